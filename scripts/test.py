# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds everything and runs the tests: ./test --help."""

import argparse
import os
import sys
import time

from checks import checks
from environment.files import cache_folder
from environment.messages import Failure, Obstacle, duration, run_main, say
from environment.packages import meshlab_version
from hosts import aarch64, hosts, reach

ABOUT = f"""\
Without options, ./test tests the core, and the plugins in the MeshLab installed here. Only tests whose names match a
REGEX run; without one all but "wheel", which takes minutes. A MeshLab of another version than the one installed here runs
in a root: the release of Debian that packages it, kept in {cache_folder()}/roots, made as root by debootstrap.
"""


def parse(words):
    parser = argparse.ArgumentParser("./test", description=ABOUT, allow_abbrev=False)
    parser.add_argument("regex", nargs="*", metavar="REGEX")
    parser.add_argument("--host", choices=[*hosts.NAMES, "all"], help="the MeshLab to test in; all: also the core")
    parser.add_argument("--versions", action="store_true",
                        help="in other MeshLabs than the one installed here, only what may differ between versions")
    parser.add_argument("--required", action="store_true",
                        help="a host that cannot be set up, or another program that a test misses, is a failure")
    parser.add_argument("--checks", action="store_true",
                        help="static analysis, the core under sanitizers, its coverage, some fuzzing; after the tests")
    parser.add_argument("--nightly", action="store_true",
                        help="everything: all tests in all hosts, long checks, large meshes, --sanitized, --threads, --reach")
    parser.add_argument("--fuzz", type=int, metavar="SECONDS", help="fuzzing alone")
    parser.add_argument("--sanitized", action="store_true", help="GUI tests with plugins compiled with sanitizers, "
                        f"without a REGEX {' '.join(checks.GUI_TESTS)}")
    parser.add_argument("--threads", action="store_true",
                        help="the core's tests of threads under ThreadSanitizer; REGEX is a filter of GoogleTest")
    parser.add_argument("--reach", action="store_true",
                        help="the portable plugins in MeshLabs that did not build them, the packages, the wheel, and --aarch64")
    parser.add_argument("--aarch64", action="store_true", help="of --reach, only that another processor computes the same")
    return parser.parse_intermixed_args(words)


class Stages:
    """How the stages of a run ended, and what each took: a line as it ends, and a table at the end of the run."""

    def __init__(self, required):
        """Skipped means kept from running by an Obstacle; a failure if `required`."""
        self.required, self.rows, self.failed = required, [], False

    def __call__(self, name, function, *words):
        """Runs it; a remark that it returns is printed. Returns whether it succeeded."""
        began, spent, succeeded = time.monotonic(), sum(os.times()[:4]), False
        try:
            remark = function(*words)
            result, succeeded = f"passed, {remark}" if remark else "passed", True
        except Obstacle as reason:
            result = f"skipped: {reason}"
            self.failed |= self.required
        except Failure as failure:
            if str(failure):
                say(failure)
            result, self.failed = "FAILED", True
        took = time.monotonic() - began
        self.rows.append(f"{took:7.0f}{sum(os.times()[:4]) - spent:7.0f}  {name:28}{result}")
        say(f"{name}: {result}, {duration(took)}")
        return succeeded

    def tell(self):
        """The exit code."""
        if len(self.rows) > 1:
            say("seconds by the clock, of processors:")
            for row in self.rows:
                say(row)
        return int(self.failed)


def test_hosts(stage, options):
    names = hosts.NAMES if options.host == "all" else [options.host]
    if options.host == "all":
        stage(f"core and MeshLab {meshlab_version()}", hosts.test_here, options.regex)
    for name in names:
        if not (options.host == "all" and hosts.is_here(name)):
            stage(name, hosts.test_host, name, options.regex, options.versions)


def main():
    options = parse(sys.argv[1:])
    if options.nightly:
        options.host, options.required, options.checks, options.reach = "all", True, True, True
    if options.required:
        os.environ["LAPLACIAN_LINES_REQUIRED"] = "true"  # by tests that would be skipped
    if options.fuzz:
        return print(checks.fuzz_alone(options.fuzz))
    if options.sanitized:
        return checks.test_gui(options.regex)
    if options.threads:
        return print(checks.test_threads(options.regex))
    if not (options.host or options.checks or options.reach or options.aarch64):
        return hosts.test_here(options.regex)
    if options.regex and not options.host:
        raise Failure("--checks, --reach and --aarch64 take no names of tests")

    stage = Stages(options.required)
    if options.host:
        test_hosts(stage, options)
    if options.checks:
        checks.run_checks(stage, options.nightly)
    if options.reach:
        reach.run_stages(stage)
    elif options.aarch64:
        stage("aarch64", aarch64.test)
    return stage.tell()


run_main(main)
