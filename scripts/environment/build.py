# SPDX-License-Identifier: GPL-3.0-or-later
"""Configure and build, quietly unless something fails."""

import os
import pathlib
import shutil

from environment import packages
from environment.files import compiled_folder, locked
from environment.headers import ensure_headers
from environment.messages import Failure, quietly, say

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]


def ensure_toolchain(*extra_packages):
    """All that building takes, MeshLab included. Returns the folder of its headers."""
    packages.ensure_packages(*packages.BUILD, *extra_packages)
    packages.ensure_meshlab_recommends()
    return ensure_headers()


def ctest(build, label, regexes=(), processes=1):
    """The command that runs tests: with a label that `label` is in, "" for any, and a name that matches a regex; without
    either, all but those that take minutes."""
    labels = ["--label-regex", label] if label else [] if regexes else ["--label-exclude", "^reach$"]
    names = ["--tests-regex", "|".join(regexes)] if regexes else []
    return ["ctest", "--test-dir", build, "--no-tests=error", "--output-on-failure", "--parallel", str(processes), *labels, *names]


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
    installs these and all that building takes first; otherwise MeshLab is that which was found before, or none."""
    build, environment = build or build_folder(checkout), compiling(checkout, **environment)
    with locked(build):
        words = [*(["--preset", preset] if preset else []), *options]
        if extra_packages is not None:
            words.append(f"-DMESHLAB_SOURCE_DIR={ensure_toolchain(*extra_packages)}")
            say(f"building {' '.join(targets) or 'all'} for MeshLab {packages.meshlab_version()}")
        cache = build / "CMakeCache.txt"
        if cache.exists() and f"\nCMAKE_HOME_DIRECTORY:INTERNAL={checkout}\n" not in cache.read_text():
            # CMake refuses it, and its objects may be of other sources
            say("this checkout was moved or copied with its build: building anew")
            for folder in build.iterdir():
                shutil.rmtree(folder, ignore_errors=True)  # not files
            cache.unlink()
        if not quietly(build / "configure.log", ["cmake", "-S", checkout, "-B", build, *words], env=environment):
            raise Failure("cmake could not configure the build")
        command = ["cmake", "--build", build, "--parallel", str(processors()), *(["--target", *targets] if targets else [])]
        if not quietly(build / "build.log", command, env=environment):
            raise Failure(f"the build failed; its whole output is in {build / 'build.log'}")
