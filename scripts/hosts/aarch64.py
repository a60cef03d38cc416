# SPDX-License-Identifier: GPL-3.0-or-later
"""./test --reach: the core, the command laplacian-lines and the plugins for another processor, compiled by Debian's cross
compiler in a root of its own and run by qemu. Fields, lines and drawings have to be those of this processor, bit by
bit."""

import filecmp
import os
import shutil

from environment import packages
from environment.build import CHECKOUT, build_folder, build_targets, ctest, processors
from environment.files import cache_folder, compiled_folder
from environment.messages import Failure, run
from environment.releases import SUITES
from hosts import aarch64_wheel
from hosts.roots import ensure_root, in_root, run_with_network
from product.display import SETTINGS, display

BUILD = CHECKOUT / "build/aarch64"
SUITE = SUITES["2020"]
TARGETS = ("print_bits write_reference laplacian_lines_drawing mesh_files_tests line_drawing_tests core_tests"
           " filter_laplacian_lines decorate_laplacian_lines meshlab_driver").split()
# qemu takes some thirty times as long: a few quick tests of each subject. And its own assertions fail where a forked process
# begins threads (ThreadPool.GoesOn...).
TESTS = (r"^(Extraction|Meshes/PlainComparison.*/(three_sheets|dirty_torus)|Views/TorusLines|Ridges\.(KnowTheir|OfAnEll)"
         r"|Creases\.AreTheTwelve|Surfaces/LaplacianConvergence.*/torus$|ThreadPool\.[^EG]|Fading|Horizon|WholeFiles|Polygons"
         r"|DamagedFiles|SheetFiles|PdfFiles|CurveFitting|MeasuredDrawing|Sections|Overlaps)")
# Whose positions are the same everywhere: those moved by random numbers depend on the order in which a compiler asks
# for them.
MESHES = "torus bumpy_sphere cube moebius_strip three_sheets rounded_cube triangle_soup doubled_triangles".split()
DRAWINGS = {"usual.svg": [], "all.svg": ["--kinds", "all_kinds", "--scale", "10:1"],
            "six.pdf": ["--views", "six", "--section", "y=0.5"], "six.dxf": ["--views", "six", "--hidden", "dashed"]}

# What the driver does in MeshLab's window.
WINDOW = """time-limit 900
wait
load torus.ply
check Show Info Panel off
check Show Trackball off
check Laplacian Lines on
check Laplacian Lines Probe on
setdeco Line Color = #ff0000
setdeco Contour Color = #ff0000
expect-lines
grab window.png
quit
"""
SETTINGS_FILE = f"mkdir -p ~/.config/VCG; printf '%s' '{SETTINGS}' >~/.config/VCG/MeshLab_64bit_fp.conf"


def install(root, kept):
    """Python of two processors is not installed side by side: the program alone of the other is unpacked elsewhere."""
    native = "g++-aarch64-linux-gnu g++-11 qemu-user make cmake ccache xz-utils libeigen3-dev"
    foreign = ("libgtest-dev qtbase5-dev libqt5opengl5-dev libglew-dev libgl-dev libglu1-mesa-dev meshlab"
               f" lib{aarch64_wheel.PYTHON.name}-dev").split()
    python = aarch64_wheel.PYTHON.parents[2]
    script = f"""dpkg --add-architecture arm64
apt-get -qq update
DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends install {native} {' '.join(f'{n}:arm64' for n in foreign)}
cd /tmp
apt-get -qq download {aarch64_wheel.PYTHON.name}-minimal:arm64
dpkg-deb --extract {aarch64_wheel.PYTHON.name}-minimal_*.deb {python}
printf '#!/bin/sh\nexec qemu-aarch64 {aarch64_wheel.PYTHON} "$@"\n' >{python}/python
chmod +x {python}/python
python3 -B -c 'from environment.headers import ensure_headers as e; e()'"""
    return run_with_network(root, kept, ["sh", "-exc", script])


def run_in_root(command, failure, *more_binds):
    root, lock = ensure_root(SUITE, "-arm64", install)
    with lock:
        for folder in (BUILD, compiled_folder()):
            folder.mkdir(parents=True, exist_ok=True)
        binds = [f"ro:{CHECKOUT}", f"rw:{BUILD}", f"ro:{cache_folder()}/headers", f"rw:{compiled_folder()}",
                 *more_binds]
        words = ["env", f"PYTHONPATH={CHECKOUT}/scripts", *command]
        if in_root(root, "ro", binds, words, LAPLACIAN_LINES_BUILD=str(BUILD)) != 0:
            raise Failure(failure)


def build():
    """There, and what it is compared with here."""
    program = f"from environment.build import build_targets; build_targets(*{TARGETS}, preset='aarch64')"
    run_in_root(["python3", "-B", "-c", program], "the build for aarch64 failed")
    build_targets("print_bits", "write_reference", "laplacian_lines_drawing", "lines_example", preset="tests",
                  extra_packages=[*packages.DISPLAY, *packages.TEST])


def test():
    run_in_root(ctest(BUILD, "all", "--parallel", str(processors()), "--tests-regex", TESTS), "tests fail on aarch64")


def commands(folder, emulator):
    """What writes hashes and drawings into the folder, by the programs of a build."""
    build = BUILD if emulator else build_folder()
    programs = [f"{emulator} {build}/tests/core/print_bits {' '.join(MESHES)} >bits.txt"]
    programs += [f"{emulator} {build}/bin/laplacian-lines {name} {' '.join(options)} ../torus.ply"
                 for name, options in DRAWINGS.items()]
    return ["sh", "-e", "-c", "; ".join([f"cd {folder}", *programs])]


def compare():
    work = BUILD / "bits"
    shutil.rmtree(work, ignore_errors=True)
    for name in ("here", "there"):
        (work / name).mkdir(parents=True)
    if run([build_folder() / "tests/meshes/write_reference", "torus", work]) != 0:
        raise Failure("there is no mesh")
    if run(commands(work / "here", "")) != 0:
        raise Failure("here, there are no bits")
    run_in_root(commands(work / "there", "qemu-aarch64"), "on aarch64, there are no bits")
    names = ["bits.txt", *DRAWINGS]
    _, different, missing = filecmp.cmpfiles(work / "here", work / "there", names, shallow=False)
    if different or missing:
        raise Failure(f"{', '.join(different + missing)} in {work}/here and there differ")
    return f"{len(MESHES)} meshes and {len(DRAWINGS)} drawings have the same bits"


def test_plugins():
    """MeshLab of that processor runs the example's filter, whose drawing has to be that of the command here, and shows
    lines in its window."""
    example, stage, work = CHECKOUT / "docs/examples/laplacian_lines_drawing.mlx", BUILD / "stage", BUILD / "bits"
    program = f"""import pathlib
from product import stage
stage.multiarch = lambda: "aarch64-linux-gnu"
stage.copy_meshlab(pathlib.Path("{stage}"), stage.built_plugins(pathlib.Path("{BUILD}"), "plugins", "driver"))"""
    run_in_root(["python3", "-B", "-c", program], "MeshLab for aarch64 is not as expected")
    (work / "window").write_text(WINDOW)
    run_in_meshlab(work, f"meshlabserver -i torus.ply -s {example}", "drawing.svg")
    here, there = (without_metadata(work / name) for name in ("here/usual.svg", "drawing.svg"))
    if here != there:
        raise Failure(f"{work}/drawing.svg and here/usual.svg differ")
    run_in_meshlab(work, "meshlab", "window.png", "LAPLACIAN_LINES_DRIVER=window LAPLACIAN_LINES_PROBE=1")
    return "the filter's drawing is the one of the command here, and the window shows lines"


def run_in_meshlab(work, command, writes, settings=""):
    """By a display of this machine, whose socket the root sees."""
    with display(1200, 800):
        words = f"QT_QPA_PLATFORM=xcb DISPLAY={os.environ['DISPLAY']} {settings} qemu-aarch64 {BUILD}/stage/bin/{command}"
        script = f"cd {work}; rm -f {writes}; {SETTINGS_FILE}; {words}; test -s {writes}"
        run_in_root(["sh", "-e", "-c", script], f"MeshLab for aarch64 did not write {writes}", "rw:/tmp/.X11-unix")


def without_metadata(drawing):
    return [line for line in drawing.read_text().splitlines() if "<metadata>" not in line]


def build_by_oldest():
    """The core and drawings by the oldest compiler that CMake lets through."""
    folder = BUILD / "oldest"
    words = "-DCMAKE_CXX_COMPILER=g++-11 -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCMAKE_DISABLE_FIND_PACKAGE_MeshLab=ON"
    run_in_root(["sh", "-e", "-c", f"cmake -S {CHECKOUT} -B {folder} {words}; cmake --build {folder} -j {processors()}"],
                "GCC 11 does not compile the core")


def run_stages(results):
    if results.stage("aarch64: build", build):
        results.stage("aarch64: tests", test)
        results.stage("aarch64: the same bits", compare)
        results.stage("aarch64: plugins in MeshLab", test_plugins)
        results.stage("aarch64: wheel", aarch64_wheel.test, BUILD / "wheel", run_in_root)
    results.stage("the core by GCC 11", build_by_oldest)
