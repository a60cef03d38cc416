# SPDX-License-Identifier: GPL-3.0-or-later
"""The programs that load the plugins ("hosts"), and how the tests run in each of them: in the MeshLab that is installed
here where it is the one, in a root otherwise, or in PyMeshLab."""

from environment import packages
from environment.build import CHECKOUT, build_folder, build_targets, ctest, processors
from environment.messages import Failure, say, started
from hosts.roots import SUITES, run_in_root
from product import pymeshlab

NAMES = [*SUITES, "pymeshlab"]


def is_here(host):
    """Whether it is the MeshLab installed here."""
    return packages.meshlab_version().startswith(f"{host}.")


def run_ctest(build, label, regexes):
    """Several tests at once, since those with windows mostly wait."""
    say("running the tests")
    with started(ctest(build, label, regexes, 2 * processors())) as running:
        if running.wait() != 0:
            raise Failure("")


def test_here(regexes, label=""):
    """Builds and tests with the MeshLab installed here; without a label also the core."""
    build_targets(*(["meshlab_tests"] if label else []), preset="tests", extra_packages=[*packages.DISPLAY, *packages.TEST])
    run_ctest(build_folder(), label, regexes)


def test_host(host, regexes, versions=False):
    if host == "pymeshlab":
        pymeshlab.build_for_pymeshlab("pymeshlab_tests", "_core", extra_packages=[*packages.DISPLAY, *packages.TEST])
        run_ctest(pymeshlab.BUILD, "pymeshlab", regexes)
    elif is_here(host):
        test_here(regexes, "versions" if versions else "meshlab")
    else:
        say(f"MeshLab {host} in Debian {SUITES[host]}")
        words = ["--versions"] if versions else []
        run_in_root(SUITES[host], CHECKOUT / f"build/host-{host}", [CHECKOUT / "test", "--host", host, *words, *regexes])
