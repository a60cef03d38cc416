# SPDX-License-Identifier: GPL-3.0-or-later
"""Plugins for upstream's own MeshLab (AppImage, Flatpak), whatever the system: built here against the headers and the
library of the same MeshLab from the release of Debian that packages it. They may need nothing that a system of its age
lacks, so this system must not be newer than that."""

import pathlib
import shutil
import subprocess
import tempfile

from environment.build import CHECKOUT, build_targets
from environment.files import cache_folder, publish_into
from environment.headers import apt_get, ensure_headers, private_apt
from environment.messages import Failure
from product.package import make_packages
from product.plugin_needs import excess
from product.pymeshlab import MESHLAB, SUITE
from product.stage import built_plugins, multiarch

BUILD = CHECKOUT / "build/portable"
LIBRARY = "libmeshlab-common.so"


def unpack_library(folder):
    """From the package of MeshLab, of which nothing else is taken."""
    with tempfile.TemporaryDirectory() as name:
        apt = pathlib.Path(name)
        if not (private_apt(apt, SUITE, "deb") and apt_get(apt, "download", "meshlab")):
            return False
        subprocess.run(["dpkg-deb", "--extract", next(apt.glob("meshlab_*.deb")), apt / "package"], check=True)
        shutil.copy(apt / "package/usr/lib" / multiarch() / "meshlab" / LIBRARY, folder)
        return True


def build_portable(*options):
    """Into build/portable, with these options of CMake."""
    libraries = cache_folder() / "libraries" / MESHLAB
    if not (libraries / LIBRARY).exists() and not publish_into(libraries, unpack_library):
        raise Failure(f"the library of MeshLab {MESHLAB} could not be fetched")
    build_targets("meshlab_plugins", preset="portable", build=BUILD,
                  options=[f"-DMESHLAB_COMMON_LIBRARY={libraries / LIBRARY}",
                           f"-DMESHLAB_SOURCE_DIR={ensure_headers(MESHLAB, SUITE)}", *options])


def package_portable():
    """Into build/portable/packages."""
    build_portable()
    if found := excess(built_plugins(BUILD, "plugins")):
        raise Failure("built on this system, the plugins would not load on others; build them on Debian 12, or another one as "
                      "old:\n" + "\n".join(found))
    make_packages(BUILD, BUILD / "packages", ["ZIP"])
