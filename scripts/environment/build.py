# SPDX-License-Identifier: GPL-3.0-or-later
"""Configure and build, quietly unless something fails."""

import os
import pathlib
import re
import shutil

from environment import packages
from environment.files import compiled_folder, turn
from environment.headers import ensure_headers
from environment.messages import Failure, quietly, say

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]


def ensure_toolchain(*extra_packages):
    """All that building takes, MeshLab included."""
    packages.ensure_packages(*packages.BUILD, *extra_packages)
    packages.ensure_meshlab_recommends()
    ensure_headers()


# No CMake presets: with one, ctest ignores the folder of logs that it is told.
SETS_OF_TESTS = {"all": [], "tests": ["--label-exclude", "^reach$"], "meshlab": ["--label-regex", "meshlab"],
                 "versions": ["--label-regex", "versions"], "pymeshlab": ["--label-regex", "pymeshlab"]}


def ctest(build, tests, *words):
    """The command that runs a set of tests in a build folder."""
    return ["ctest", "--test-dir", build, "--output-on-failure", *SETS_OF_TESTS[tests], *words]


def build_folder(checkout=CHECKOUT):
    """A root's build is apart from this machine's."""
    return pathlib.Path(os.environ.get("LAPLACIAN_LINES_BUILD") or checkout / "build")


def processors():
    return len(os.sched_getaffinity(0))


def compiling(checkout=CHECKOUT, **environment):
    """The environment in which ccache compiles nothing twice, not even in another checkout; the sloppiness is for
    precompiled headers."""
    launcher = {"CMAKE_CXX_COMPILER_LAUNCHER": "ccache"} if shutil.which("ccache") else {}
    return {**launcher, "CCACHE_DIR": str(compiled_folder()), "CCACHE_MAXSIZE": "4G", **os.environ, "CCACHE_BASEDIR": str(checkout),
            "CCACHE_NOHASHDIR": "1", "CCACHE_SLOPPINESS": "pch_defines,time_macros", **environment}


def build_targets(*targets, preset=None, options=(), extra_packages=None, checkout=CHECKOUT, build=None, **environment):
    """Configures by a preset of CMakePresets.json and compiles all targets, or those named. With extra_packages,
    installs these and all that building takes first. Without MESHLAB_SOURCE_DIR: as configured before, or the core
    alone."""
    build, environment = build or build_folder(checkout), compiling(checkout, **environment)
    with turn(build):
        if extra_packages is not None:
            ensure_toolchain(*extra_packages)
            say(f"building {' '.join(targets) or 'all'} for MeshLab {packages.meshlab_version()}")
        forget_moved_build(checkout, build)
        words = [*(["--preset", preset] if preset else []), *options]
        if headers := os.environ.get("MESHLAB_SOURCE_DIR"):
            words.append(f"-DMESHLAB_SOURCE_DIR={headers}")
        if not quietly(build / "configure.log", ["cmake", "-S", checkout, "-B", build, *words], env=environment):
            raise Failure("cmake could not configure the build")
        command = ["cmake", "--build", build, "--parallel", str(processors()), *(["--target", *targets] if targets else [])]
        if not quietly(build / "build.log", command, env=environment):
            raise Failure(f"the build failed; its whole output is in {build / 'build.log'}")


def forget_moved_build(checkout, build):
    """Removes a build of another checkout: CMake refuses it, and its objects may be of other sources."""
    cache = build / "CMakeCache.txt"
    made_of = re.search(r"^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)$", cache.read_text(), re.M)[1] if cache.exists() else checkout
    if not (os.path.exists(made_of) and os.path.samefile(made_of, checkout)):
        say("this checkout was moved or copied with its build: building anew")
        for place in build.iterdir():
            if place.is_dir() and not place.is_symlink():
                shutil.rmtree(place)
        cache.unlink()
