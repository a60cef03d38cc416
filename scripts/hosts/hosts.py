# SPDX-License-Identifier: GPL-3.0-or-later
"""The programs that load the plugins ("hosts"), and how the tests run in each of them: in the MeshLab that is installed
here where it is the one, in a root otherwise, or in PyMeshLab."""

import os
import time

from environment import packages
from environment.build import CHECKOUT, build_folder, build_targets, ctest, processors
from environment.files import cache_folder, compiled_folder
from environment.messages import Failure, duration, say, started
from environment.releases import SUITES
from hosts.roots import ensure_root, in_root
from product import pymeshlab

NAMES = [*SUITES, "pymeshlab"]


def is_here(host):
    """Whether it is the MeshLab installed here."""
    return packages.meshlab_version().startswith(f"{host}.")


def run_ctest(build, regexes, tests):
    """Several tests at once, since those with windows mostly wait: those of a set whose names match one of the
    regexes."""
    words = ["--tests-regex", "|".join(regexes)] if regexes else []
    with started(ctest(build, tests, "--parallel", str(2 * processors()), *words)) as running:
        if running.wait() != 0:
            raise Failure("")


def test_here(regexes, tests=None):
    """Builds and tests with the MeshLab installed here; without a set also the core."""
    began = time.monotonic()
    build_targets(*(["meshlab_tests"] if tests else []), preset="tests",
                  extra_packages=[*packages.DISPLAY, *packages.TEST])
    say(f"built in {duration(time.monotonic() - began)}; running the tests")
    run_ctest(build_folder(), regexes, tests or ("all" if regexes else "tests"))


def test_in_pymeshlab(regexes):
    began = time.monotonic()
    python, build = pymeshlab.ensure_pymeshlab(), os.environ.get("LAPLACIAN_LINES_BUILD")
    try:
        pymeshlab.build_for_pymeshlab(python, "pymeshlab_tests")
        say(f"built in {duration(time.monotonic() - began)}; running the tests in PyMeshLab")
        run_ctest(pymeshlab.BUILD, regexes, "pymeshlab")
    finally:
        for name, value in (("LAPLACIAN_LINES_BUILD", build), ("MESHLAB_SOURCE_DIR", None)):
            os.environ.pop(name, None)
            if value:
                os.environ[name] = value


def test_in_root(host, regexes, versions):
    root, lock = ensure_root(SUITES[host])
    with lock:
        build = CHECKOUT / f"build/host-{host}"
        for folder in (build, compiled_folder()):
            folder.mkdir(parents=True, exist_ok=True)
        binds = [f"ro:{CHECKOUT}", f"rw:{build}", f"ro:{cache_folder()}/headers", f"rw:{compiled_folder()}"]
        if (cache_folder() / "models").is_dir():
            binds.append(f"ro:{cache_folder()}/models")
        models = CHECKOUT.parent / "shared/models"  # scanned models that may lie beside the repository
        if models.is_dir():
            binds.append(f"ro:{models.resolve()}={models}")
        say(f"MeshLab {host} in {root}")
        words = ["--versions"] if versions else []
        if in_root(root, "ro", binds, [CHECKOUT / "test", "--host", host, *words, *regexes],
                   LAPLACIAN_LINES_BUILD=str(build)) != 0:
            raise Failure("")


def test_host(host, regexes, versions=False):
    if host == "pymeshlab":
        test_in_pymeshlab(regexes)
    elif is_here(host):
        test_here(regexes, "versions" if versions else "meshlab")
    else:
        test_in_root(host, regexes, versions)
