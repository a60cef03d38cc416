# SPDX-License-Identifier: GPL-3.0-or-later
"""Debian packages: installs what is missing, and only that."""

import os
import re
import shutil
import subprocess

from environment.messages import Failure, output, say

BUILD = """meshlab g++ make cmake xz-utils qtbase5-dev libqt5opengl5-dev libglew-dev libeigen3-dev zlib1g-dev
    libstb-dev libgl-dev libglu1-mesa-dev libgl1-mesa-dri""".split()
DISPLAY = "xvfb fonts-dejavu-core".split()
CORE = "g++ make cmake libeigen3-dev zlib1g-dev libstb-dev".split()  # enough without MeshLab
PACKAGING = ["dpkg-dev", "file"]  # CPack asks them what is a library, and whose
TEST = "libgtest-dev libbenchmark-dev imagemagick ccache librsvg2-bin poppler-utils".split() + PACKAGING
CHECKS = "clang clang-format libclang-rt-dev llvm cppcheck git shellcheck python3-pyflakes universal-ctags".split()
# meshlab 2022 and later show a modal box at start when a bundled plugin misses one of these Recommends; 2020.09 depends
# on all it needs. Unknown names are skipped.
MESHLAB_RECOMMENDS = """lib3ds-1-3 libgomp1 libmuparser2v5 libopenctm1 libqhull-r8.0 libxerces-c3.2t64 libmpfr6
    libgmp10""".split()


def missing(packages):
    """All in one question, since each takes a while."""
    done = subprocess.run(["dpkg-query", "-W", "-f=${db:Status-Abbrev}${Package}\n", *packages],
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return sorted(set(packages) - set(re.findall(r"^ii (.*)$", done.stdout, re.M)))


def as_root(*command, **options):
    """Whether the command succeeds."""
    if os.geteuid() != 0:
        if not shutil.which("sudo"):
            raise Failure(f"packages are missing and neither root nor sudo is at hand; as root, run: {' '.join(command)}")
        command = "sudo", *command
    return subprocess.run(command, **options).returncode == 0


def ensure_packages(*packages):
    names = missing(packages)
    if not names:
        return
    words = " ".join(names)
    if not shutil.which("apt-get"):
        raise Failure(f"this needs the packages {words}, and there is no apt-get to install them")
    say(f"installing {words}")
    if not as_root("apt-get", "-qq", "update"):
        say("apt-get update failed; trying with the package lists at hand")
    if not as_root("env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-qq", "-y", "--no-install-recommends",
                   "install", *names, stdout=subprocess.DEVNULL):
        raise Failure(f"could not install {words}")


def meshlab_version():
    """The package's version, "" if there is none."""
    return output("dpkg-query", "-W", "-f=${Version}", "meshlab") or ""


def ensure_meshlab_recommends():
    """Only from 2022 on; asking apt-cache keeps distributions' names out of this."""
    if not meshlab_version().startswith("2020."):
        ensure_packages(*(name for name in MESHLAB_RECOMMENDS if output("apt-cache", "show", name) is not None))
