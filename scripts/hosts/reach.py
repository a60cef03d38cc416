# SPDX-License-Identifier: GPL-3.0-or-later
"""./test --reach: the portable plugins in MeshLabs that did not build them, and the packages of all releases of
Debian, the wheel for Python, and another processor."""

import os
import pathlib
import shutil
import sys

from environment import packages
from environment.build import CHECKOUT, ctest, processors
from environment.files import cache_folder
from environment.messages import Failure, run
from environment.releases import SUITES
from hosts import aarch64, hosts
from hosts.built_meshlab import ensure_built_meshlab
from hosts.roots import ensure_root, in_root
from product import portable, pymeshlab
from product.models import default_mesh
from product.stage import built_plugins

BUILD = portable.BUILD
BUNDLE = BUILD / "bundle"
GLEW = "libGLEW.so.2.3"  # as the root's MeshLab calls it
# What PyMeshLab, which shows no windows, lacks of Qt: of this system, whose Qt is nearest to its.
QT_PLUGINS = pathlib.Path("/usr/lib/x86_64-linux-gnu/qt5/plugins")
XCB = ("platforms/libqxcb.so", "xcbglintegrations/libqxcb-glx-integration.so")
GUI_TESTS = r"meshlab\.(stage|driver|install|gui_.*)$"
BUNDLE_TESTS = r"meshlab\.(stage|gui_(drawing_style|hidden_lines|render_modes|snapshot|filter|polylines|drawing))$"
PICTURE = """import pathlib, sys
from product import picture
stage, target, mesh = map(pathlib.Path, sys.argv[1:])
work = pathlib.Path("/tmp/work")
work.mkdir()
options = picture.Options()
picture.Pictures(stage, work, options, picture.columns_of(stage.parent, options.kinds, []), []).take(target, [str(mesh)])
"""


def build():
    """Tests the plugins of the .zip, stripped; driver and test programs are built here, too."""
    packages.ensure_packages(*packages.BUILD, *packages.DISPLAY, *packages.TEST)
    environment = dict(os.environ)
    try:
        portable.package_portable()
        portable.build_portable("write_reference", options=["-DLAPLACIAN_LINES_BUILD_TESTS=ON"])
    finally:
        os.environ.clear()
        os.environ.update(environment)
    archive, = (BUILD / "packages").glob("*.zip")
    shutil.unpack_archive(archive, BUILD / "unpacked")
    for plugin in built_plugins(BUILD, "unpacked"):
        shutil.copy2(plugin, BUILD / "plugins")
    if run([sys.executable, portable.NEEDS, *built_plugins(BUILD, "plugins")]) != 0:
        raise Failure("the plugins of the .zip need more")


def run_in_root(command, settings, ensure):
    root, lock = ensure()
    with lock:
        binds = [f"ro:{CHECKOUT}", f"rw:{BUILD}", f"ro:{cache_folder()}/headers"]
        models = CHECKOUT.parent / "shared/models"
        for folder, name in ((cache_folder() / "models", cache_folder() / "models"), (models.resolve(), models)):
            if folder.is_dir():
                binds.append(f"ro:{folder}={name}")
        if in_root(root, "ro", binds, ["env", f"PYTHONPATH={CHECKOUT}/scripts", *settings, *command]) != 0:
            raise Failure("")


def test_in_root(tests, name, settings=(), ensure=lambda: ensure_root(portable.SUITE)):
    """Runs the build's tests in the root, which has nothing else of this machine, and draws the dragon."""
    run_in_root(ctest(BUILD, "meshlab", "--parallel", str(processors()), "--tests-regex", tests), settings, ensure)
    run_in_root(["python3", "-B", "-c", PICTURE, BUILD / "stage", BUILD / f"dragon_{name}.png", default_mesh()], settings,
                ensure)


def test_in_bundle():
    """The same MeshLab with upstream's Qt and GLEW, as the AppImage has them."""
    python = pathlib.Path(pymeshlab.ensure_pymeshlab())
    libraries = next(python.parents[1].glob("lib/python*/site-packages/pymeshlab/lib"))
    shutil.rmtree(BUNDLE, ignore_errors=True)
    BUNDLE.mkdir()
    for pattern in ("libQt5*.so.5", "libicu*.so.56", "libexternal-glew.so"):
        for library in libraries.glob(pattern):
            shutil.copy2(library, BUNDLE)
    (BUNDLE / GLEW).symlink_to("libexternal-glew.so")
    for plugin in XCB:
        (BUNDLE / plugin).parent.mkdir()
        shutil.copy2(QT_PLUGINS / plugin, BUNDLE / plugin)
    test_in_root(BUNDLE_TESTS, "bundle", [f"LD_LIBRARY_PATH={BUNDLE}", f"QT_PLUGIN_PATH={BUNDLE}"])


def check_packages():
    """Those made by the tests in all hosts."""
    packages.ensure_packages("lintian")
    made = list((CHECKOUT / "build").glob("**/Testing/meshlab/package/packages/*.deb"))
    if run(["lintian", "--allow-root", "--fail-on", "error", *made]) != 0 or len(made) < len(SUITES):
        raise Failure(f"lintian finds errors in {made}")


def run_stages(results):
    results.stage("portable plugins", build)
    results.stage(f"MeshLab of Debian {portable.SUITE}", test_in_root, GUI_TESTS, "debian")
    results.stage("that with upstream's libraries", test_in_bundle)
    results.stage(f"MeshLab built on Debian {SUITES['2020']}", test_in_root, BUNDLE_TESTS, "built", (), ensure_built_meshlab)
    for host in SUITES:
        results.stage(f"package in MeshLab {host}", hosts.test_host, host, [r"meshlab\.(stage|package)$"])
    results.stage("lintian", check_packages)
    results.stage("wheel", hosts.test_here, ["wheel"])
    aarch64.run_stages(results)
