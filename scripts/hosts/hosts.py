# SPDX-License-Identifier: GPL-3.0-or-later
"""The programs that load the plugins ("hosts"), and how the tests run in each of them: in the MeshLab that is installed
here where it is the one, in a root otherwise, or in PyMeshLab."""

import time

from environment import packages
from environment.build import CHECKOUT, build_folder, build_targets, ctest, processors
from environment.messages import Failure, duration, say, started
from hosts.roots import SUITES, run_in_root
from product import pymeshlab

NAMES = [*SUITES, "pymeshlab"]


def is_here(host):
    """Whether it is the MeshLab installed here."""
    return packages.meshlab_version().startswith(f"{host}.")


def run_ctest(began, build, regexes, tests):
    """Several tests at once, since those with windows mostly wait: those of a set whose names match one of the
    regexes."""
    say(f"built in {duration(time.monotonic() - began)}; running the tests")
    words = ["--tests-regex", "|".join(regexes)] if regexes else []
    with started(ctest(build, tests, "--parallel", str(2 * processors()), *words)) as running:
        if running.wait() != 0:
            raise Failure("")


def test_here(regexes, tests=None):
    """Builds and tests with the MeshLab installed here; without a set also the core."""
    began = time.monotonic()
    build_targets(*(["meshlab_tests"] if tests else []), preset="tests", extra_packages=[*packages.DISPLAY, *packages.TEST])
    run_ctest(began, build_folder(), regexes, tests or ("all" if regexes else "tests"))


def test_host(host, regexes, versions=False):
    began = time.monotonic()
    if host == "pymeshlab":
        pymeshlab.build_for_pymeshlab("pymeshlab_tests", "_core", extra_packages=[*packages.DISPLAY, *packages.TEST])
        run_ctest(began, pymeshlab.BUILD, regexes, "pymeshlab")
    elif is_here(host):
        test_here(regexes, "versions" if versions else "meshlab")
    else:
        say(f"MeshLab {host} in Debian {SUITES[host]}")
        words = ["--versions"] if versions else []
        run_in_root(SUITES[host], CHECKOUT / f"build/host-{host}", [CHECKOUT / "test", "--host", host, *words, *regexes])
