# SPDX-License-Identifier: GPL-3.0-or-later
"""Plugins for upstream's own MeshLab (AppImage, Flatpak), whatever the system: built here against the headers and the
library of the same MeshLab from the release of Debian that packages it. They may need nothing that a system of its age
lacks, so this system must not be newer than that."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from environment.build import CHECKOUT, build_targets
from environment.files import cache_folder, publish_into
from environment.headers import source_apt_get, write_source_list
from environment.messages import Failure, Obstacle, say
from environment.releases import SUITES
from product import pymeshlab
from product.package import make_packages
from product.stage import built_plugins, multiarch

BUILD = CHECKOUT / "build/portable"
SUITE = SUITES[pymeshlab.HOST]
LIBRARY = "libmeshlab-common.so"
NEEDS = pathlib.Path(__file__).with_name("plugin_needs.py")


def unpack_library(folder):
    """From the package of MeshLab, of which nothing else is taken."""
    with tempfile.TemporaryDirectory() as name:
        apt = pathlib.Path(name)
        (apt / "lists/partial").mkdir(parents=True)
        (apt / "cache").mkdir()
        if not (write_source_list(apt / "sources", SUITE, "deb") and source_apt_get(apt, "update") and
                source_apt_get(apt, "download", "meshlab", cwd=apt)):
            return False
        subprocess.run(["dpkg-deb", "--extract", next(apt.glob("meshlab_*.deb")), apt / "package"], check=True)
        shutil.copy(apt / "package/usr/lib" / multiarch() / "meshlab" / LIBRARY, folder)
        return True


def build_portable(*targets, options=()):
    """Into build/portable, for this process."""
    try:
        pymeshlab.ensure_meshlab_headers()
    except Obstacle as reason:
        raise Failure(reason) from None
    libraries = cache_folder() / "libraries" / pymeshlab.MESHLAB
    if not (libraries / LIBRARY).exists() and not publish_into(libraries, unpack_library):
        raise Failure(f"the library of MeshLab {pymeshlab.MESHLAB} could not be fetched")
    os.environ["LAPLACIAN_LINES_BUILD"] = str(BUILD)
    say(f"building plugins for all systems with MeshLab {pymeshlab.MESHLAB}")
    build_targets("meshlab_plugins", *targets, preset="portable",
                  options=[f"-DMESHLAB_COMMON_LIBRARY={libraries / LIBRARY}", *options])


def package_portable():
    """Into build/portable/packages."""
    build_portable()
    with open(BUILD / "needs.txt", "w", encoding="utf-8") as needs:
        if subprocess.run([sys.executable, NEEDS, *built_plugins(BUILD, "plugins")], stdout=needs).returncode != 0:
            raise Failure("built on this system, the plugins would not load on others; build them on Debian 12, or another "
                          "one as old")
    make_packages(BUILD, BUILD / "packages", ["ZIP"])
