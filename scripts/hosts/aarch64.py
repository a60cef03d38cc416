# SPDX-License-Identifier: GPL-3.0-or-later
"""./test --aarch64: the core, the command laplacian-lines and the plugins for another processor, compiled by Debian's cross
compiler in a root of its own. Run by qemu, fields, lines and drawings have to be those of this processor, bit by
bit."""

import filecmp
import shutil

from environment import packages
from environment.build import CHECKOUT, build_folder, build_targets
from environment.messages import Failure, run
from hosts.roots import SUITES, run_in_root, run_with_network

BUILD = CHECKOUT / "build/aarch64"
TARGETS = "print_bits write_reference laplacian_lines_drawing".split()
PLUGINS = "filter_laplacian_lines decorate_laplacian_lines".split()
# Whose positions are the same everywhere: those moved by random numbers depend on the order in which a compiler asks
# for them.
MESHES = "torus bumpy_sphere cube moebius_strip three_sheets rounded_cube triangle_soup doubled_triangles".split()
DRAWINGS = {"usual.svg": [], "all.svg": ["--kinds", "all_kinds", "--scale", "10:1"],
            "six.pdf": ["--views", "six", "--section", "y=0.5"], "six.dxf": ["--views", "six", "--hidden", "dashed"]}


def install(root, kept, log):
    native = "g++-aarch64-linux-gnu qemu-user make cmake ccache xz-utils libeigen3-dev"
    foreign = """libgtest-dev qtbase5-dev libqt5opengl5-dev libglew-dev zlib1g-dev libstb-dev libgl-dev libglu1-mesa-dev
        meshlab""".split()
    return run_with_network(root, kept, ["sh", "-exc", f"""dpkg --add-architecture arm64
apt-get -qq update
DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends install {native} {' '.join(f'{n}:arm64' for n in foreign)}
python3 -B -c 'from environment.headers import ensure_headers as e; e()'"""], log)


def run_there(*command):
    run_in_root(SUITES["2020"], BUILD, command, "-arm64", install)


def bits(build, folder, emulator=""):
    """A command that writes hashes and drawings into the folder, by the programs of a build."""
    folder.mkdir(parents=True)
    programs = [f"{emulator} {build}/tests/core/print_bits {' '.join(MESHES)} >bits.txt"]
    programs += [f"{emulator} {build}/bin/laplacian-lines {name} {' '.join(options)} ../torus.ply"
                 for name, options in DRAWINGS.items()]
    return "sh", "-ec", "; ".join([f"cd {folder}", *programs])


def test():
    program = f"from environment.build import build_targets as b; b(*{TARGETS + PLUGINS}, preset='aarch64')"
    run_there("python3", "-B", "-c", program)
    build_targets(*TARGETS, preset="tests", extra_packages=[*packages.DISPLAY, *packages.TEST])
    work, names = BUILD / "bits", ["bits.txt", *DRAWINGS]
    shutil.rmtree(work, ignore_errors=True)
    here = bits(build_folder(), work / "here")
    if run([build_folder() / "tests/meshes/write_reference", "torus", work]) != 0 or run(here) != 0:
        raise Failure("here, there are no bits")
    run_there(*bits(BUILD, work / "there", "qemu-aarch64"))
    _, different, missing = filecmp.cmpfiles(work / "here", work / "there", names, shallow=False)
    if different or missing:
        raise Failure(f"{', '.join(different + missing)} in {work}/here and there differ")
    return f"{len(MESHES)} meshes and {len(DRAWINGS)} drawings have the same bits"
