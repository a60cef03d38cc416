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


def build_targets(*targets, preset=None, options=(), extra_packages=None, checkout=CHECKOUT):
    """Configures by a preset of CMakePresets.json and compiles all targets, or those named. With extra_packages,
    installs these and all that building takes first."""
    build = build_folder(checkout)
    words = [*(["--preset", preset] if preset else []), *options]
    circumstances, wanted = circumstances_of(checkout, options), repr((targets, preset, extra_packages))
    if wanted in latest_builds(checkout, build, circumstances):
        return
    with turn(build):
        built = latest_builds(checkout, build, circumstances)
        if wanted in built:
            return
        if extra_packages is not None:
            ensure_toolchain(*extra_packages)
            say(f"building {' '.join(targets) or 'all'} for MeshLab {packages.meshlab_version()}")
        (build / ".begun").touch()
        configure(checkout, build, words)
        compile_targets(checkout, build, targets)
        (build / ".built").write_text("\n".join((circumstances, *built, wanted)))
        (build / ".begun").rename(build / ".sources")  # what is changed while it is compiled may not be in it


def circumstances_of(checkout, options):
    """What changes all that is built, in a line."""
    return repr((str(checkout), *options, *map(os.environ.get, ("MESHLAB_SOURCE_DIR", "CXX", "CXXFLAGS",
                                                                "CMAKE_CXX_COMPILER_LAUNCHER"))))


def latest_builds(checkout, build, circumstances):
    """Those since which nothing that CMake or make look at was touched: folders of sources, packages, and what was made.
    CMake and make take seconds to find that out."""
    try:
        circumstances_then, *built = (build / ".built").read_text().split("\n")
        if circumstances_then != circumstances:
            return []
        sources = [place for place in checkout.iterdir() if place.is_dir() and place.name != ".git"
                   and not place.samefile(build)]
        made = [place for name in ("plugins", "driver", "bin") if (place := build / name).is_dir()]
        touched = (newer(build / ".sources", *all_in(*sources), *checkout.glob("CMake*"), "/var/lib/dpkg/status") or
                   newer(build / ".built", *all_in(*made), build / "CMakeCache.txt"))
        return [] if touched else built
    except OSError:
        return []


def all_in(*folders):
    """With the folders themselves; os.walk() takes a fifth of pathlib's time."""
    for folder in folders:
        for place, _, files in os.walk(folder):
            yield place
            yield from (f"{place}/{file}" for file in files)


def processors():
    return len(os.sched_getaffinity(0))


def newer(file, *others):
    time = os.stat(file).st_mtime_ns
    return any(os.lstat(other).st_mtime_ns > time for other in others)


def cached(build, name):
    """A value of its CMake cache."""
    found = re.search(rf"^{name}:[A-Z]*=(.*)$", (build / "CMakeCache.txt").read_text(errors="surrogateescape"), re.M)
    return found[1] if found else ""


def forget_moved_build(checkout, build):
    """Removes a build that was made elsewhere or of another checkout: CMake refuses it, and its objects may be of other
    sources. Builds in folders inside it look after themselves."""
    if not (build / "CMakeCache.txt").exists():
        return
    places = ((cached(build, "CMAKE_HOME_DIRECTORY"), checkout), (cached(build, "CMAKE_CACHEFILE_DIR"), build))
    if all(os.path.exists(was) and os.path.samefile(was, now) for was, now in places):
        return
    say("this checkout was moved or copied with its build: rebuilding")
    (build / "CMakeCache.txt").unlink()
    for folder, below, files in os.walk(build):
        if "CMakeCache.txt" in files:
            below.clear()
        for name in [name for name in below if name == "CMakeFiles" or name.endswith("_autogen")]:
            shutil.rmtree(os.path.join(folder, name))
            below.remove(name)


def configure(checkout, build, words):
    """Without MESHLAB_SOURCE_DIR: as configured before, or the core alone."""
    forget_moved_build(checkout, build)
    words = list(words)
    if not os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER") and shutil.which("ccache"):
        words.insert(0, "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    if headers := os.environ.get("MESHLAB_SOURCE_DIR"):
        words.insert(0, f"-DMESHLAB_SOURCE_DIR={headers}")
    if not quietly(build / "configure.log", ["cmake", "-S", checkout, "-B", build, *words]):
        raise Failure("cmake could not configure the build")


def compile_targets(checkout, build, targets):
    """With ccache nothing is compiled twice, not even in another checkout. The sloppiness is for precompiled
    headers."""
    ccache = {"CCACHE_DIR": str(compiled_folder()), "CCACHE_MAXSIZE": "4G", **os.environ,
              "CCACHE_BASEDIR": str(checkout),
              "CCACHE_NOHASHDIR": "1", "CCACHE_SLOPPINESS": "pch_defines,time_macros"}
    command = ["cmake", "--build", build, "--parallel", str(processors()), *(["--target", *targets] if targets else [])]
    if not quietly(build / "build.log", command, env=ccache):
        raise Failure(f"the build failed; its whole output is in {build / 'build.log'}")
