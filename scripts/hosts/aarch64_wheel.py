# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel for aarch64: built by a Python of that processor, which qemu runs while CMake and the compiler it calls are
this processor's own, and tested by it against what programs of this processor compute."""

import pathlib
import shutil
import sys
import zipfile

from environment.build import CHECKOUT, build_folder
from environment.files import compiled_folder
from environment.messages import Failure, run
from environment.python_environments import ensure_python

PYTHON = pathlib.Path("/opt/aarch64/usr/bin/python3.11")  # in the root, whose Debian has this version
TESTS = CHECKOUT / "tests/wheel"
BUILD_WHEEL = """import sys
from scikit_build_core.build import build_wheel
sys.executable, wheels, build = sys.argv[1:]
defined = {"SYSTEM_NAME": "Linux", "SYSTEM_PROCESSOR": "aarch64", "CXX_COMPILER": "aarch64-linux-gnu-g++",
           "CXX_FLAGS": "-Wno-psabi", "CXX_COMPILER_LAUNCHER": "ccache"}
build_wheel(wheels, {"build-dir": build, **{f"cmake.define.CMAKE_{name}": word for name, word in defined.items()}})
"""
WRITE_REFERENCE = """import pathlib, sys
sys.path.insert(0, sys.argv[1])
from bare_environments import write_reference
write_reference(*map(pathlib.Path, sys.argv[2:]))
"""


def install_packages(folder):
    """What building and running take, for aarch64."""
    pip = ensure_python("pip", "1", "20 MB", "pip")
    platforms = [f"--platform=manylinux_2_{minor}_aarch64" for minor in range(17, 37)]
    names = "numpy", "nanobind>=3.1,<4", "nanobind-backend>=1,<2", "scikit-build-core"
    if run([pip, "-m", "pip", "--disable-pip-version-check", "--quiet", "install", "--target", folder, *platforms,
            "--python-version", PYTHON.name.removeprefix("python"), "--only-binary", ":all:", *names]) != 0:
        raise Failure("packages of Python for aarch64 could not be had")


def test(work, run_in_root):
    """In this folder of the build."""
    shutil.rmtree(work, ignore_errors=True)
    install_packages(work / "packages")
    path = f"PYTHONPATH={work / 'packages'}:{work / 'unpacked'}"
    python = ["env", path, "CMAKE_GENERATOR=Unix Makefiles", f"CCACHE_DIR={compiled_folder()}", "qemu-aarch64", PYTHON, "-B"]
    run_in_root(["sh", "-ec", 'cd "$0"; exec "$@"', CHECKOUT / "programs/python", *python, "-c", BUILD_WHEEL,
                 PYTHON.parents[2] / "python", work / "wheels", work / "build"], "there is no wheel for aarch64")
    wheel, = (work / "wheels").glob("*-cp310-abi3-linux_aarch64.whl")
    zipfile.ZipFile(wheel).extractall(work / "unpacked")
    build = build_folder()
    programs = build / "tests/meshes/write_reference", build / "tests/wheel/lines_example", build / "bin/laplacian-lines"
    if run([sys.executable, "-B", "-c", WRITE_REFERENCE, TESTS, work, *programs]) != 0:
        raise Failure("here, there are no lines to compare with")
    # of drawings and fields alone: those of lines and of refusals take qemu many minutes
    run_in_root(["env", f"LAPLACIAN_LINES_REFERENCE={work / 'reference'}", *python, "-m", "unittest", "discover",
                 "--start-directory", TESTS / "cases", "--pattern", "test_[df]*.py"], "the wheel's tests fail on aarch64")
    return f"{wheel.name}, {wheel.stat().st_size / 1e6:.2f} MB"
