# SPDX-License-Identifier: GPL-3.0-or-later
"""./test --reach: the portable plugins in MeshLabs that did not build them, and the packages of all releases of
Debian, and the wheel for Python. Then come the other systems."""

import shutil

from environment import packages
from environment.build import CHECKOUT, ctest, processors
from environment.messages import Failure, run
from hosts import aarch64, hosts, windows
from hosts.roots import SUITES, run_in_root
from product import portable
from product.plugin_needs import excess
from product.stage import built_plugins

BUILD = portable.BUILD
SYSTEMS = {"aarch64": aarch64.test, "windows": windows.test}
GUI_TESTS = r"meshlab\.(stage|driver|install|gui_.*)$"


def build():
    """The plugins of the .zip, which are stripped, in the place of those built, and the driver, for tests."""
    packages.ensure_packages(*packages.BUILD, *packages.DISPLAY, *packages.TEST)
    portable.package_portable()
    portable.build_portable("-DLAPLACIAN_LINES_BUILD_TESTS=ON")
    archive, = (BUILD / "packages").glob("*.zip")
    shutil.unpack_archive(archive, BUILD / "unpacked")
    for plugin in built_plugins(BUILD, "unpacked"):
        shutil.copy2(plugin, BUILD / "plugins")
    if found := excess(built_plugins(BUILD, "plugins")):
        raise Failure("\n".join(found))


def test_in_root():
    """Runs the build's tests in the root, which has nothing else of this machine."""
    run_in_root(portable.SUITE, BUILD, ctest(BUILD, "meshlab", [GUI_TESTS], processors()))


def check_packages():
    """Those made by the tests in all hosts."""
    packages.ensure_packages("lintian")
    made = list((CHECKOUT / "build").glob("**/Testing/meshlab/package/packages/*.deb"))
    if run(["lintian", "--allow-root", "--fail-on", "error", *made]) != 0 or len(made) < len(SUITES):
        raise Failure(f"lintian finds errors, or it has not a package of each MeshLab: {made}")


def run_stages(stage):
    stage("portable plugins", build)
    stage(f"MeshLab of Debian {portable.SUITE}", test_in_root)
    for host in SUITES:
        stage(f"package in MeshLab {host}", hosts.test_host, host, [r"meshlab\.(stage|package)$"])
    stage("lintian", check_packages)
    stage("wheel", hosts.test_here, ["wheel"])
