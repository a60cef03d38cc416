# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds everything and runs the tests: ./test --help."""

import os
import time

from checks import checks
from environment.files import cache_folder
from environment.messages import Failure, Unavailable, run_main, say
from environment.options import Parser
from environment.packages import meshlab_version
from hosts import hosts, reach

ABOUT = f"""\
Without options, ./test tests the core, and the plugins in the MeshLab installed here. Only tests whose names match a
REGEX run; without one all but "wheel", which takes minutes. A MeshLab of another version than the one installed here runs
in a root: the release of Debian that packages it, kept in {cache_folder()}/roots, made as root by debootstrap.
"""
FLAGS = {
    "--versions": "only what may differ between MeshLab's versions; of --host all, in those not installed here",
    "--required": "a host that cannot be set up, or another program that a test misses, is a failure",
    "--checks": "static analysis, the core under sanitizers, its coverage, some fuzzing; after the tests",
    "--nightly": "everything: all tests in all hosts, long checks, large meshes, --sanitized, --threads, --reach",
    "--sanitized": "GUI tests with plugins compiled with sanitizers, without a REGEX " + " ".join(checks.GUI_TESTS),
    "--threads": "the core's tests of threads under ThreadSanitizer; REGEX is a filter of GoogleTest",
    "--reach": "the portable plugins in MeshLabs that did not build them, the packages, the wheel, --aarch64 and --windows",
    "--aarch64": "of --reach, only that another processor computes the same",
    "--windows": "of --reach, only that the command for Windows, run by Wine, draws the same"}


def parse():
    parser = Parser("./test", description=ABOUT)
    parser.add_argument("regex", nargs="*", metavar="REGEX")
    parser.add_argument("--host", choices=[*hosts.NAMES, "all"], help="the MeshLab to test in; all: also the core")
    parser.add_argument("--fuzz", type=int, metavar="SECONDS", help="fuzzing alone")
    for flag, meaning in FLAGS.items():
        parser.add_argument(flag, action="store_true", help=meaning)
    return parser.parse_intermixed_args()


class Stages:
    """How the stages of a run ended, and what each took: a line as it ends, and all again at the end of the run."""

    def __init__(self, required):
        """Skipped means kept from running by an Unavailable; a failure if `required`."""
        self.required, self.lines, self.failed = required, [], False

    def __call__(self, name, function, *words):
        """Runs it; a remark that it returns is printed. Returns whether it succeeded."""
        began, succeeded = time.monotonic(), False
        try:
            remark = function(*words)
            result, succeeded = f"passed, {remark}" if remark else "passed", True
        except Unavailable as reason:
            result = f"skipped: {reason}"
            self.failed |= self.required
        except Failure as failure:
            result, self.failed = f"FAILED {failure}", True
        self.lines.append(f"{name}: {result}, {time.monotonic() - began:.0f} s")
        say(self.lines[-1])
        return succeeded

    def tell(self):
        """The exit code."""
        for line in self.lines if len(self.lines) > 1 else ():
            say(line)
        return int(self.failed)


def main():
    options = parse()
    if options.nightly:
        options.host, options.required, options.checks, options.reach = "all", True, True, True
    if options.required:
        os.environ["LAPLACIAN_LINES_REQUIRED"] = "true"  # by tests that would be skipped
    if options.versions and not options.host or options.fuzz is not None and options.fuzz < 1:
        raise Failure("--versions goes with --host, and --fuzz takes at least a second")
    if options.fuzz:
        return print(checks.fuzz_alone(options.fuzz))
    if options.sanitized:
        return checks.test_gui(options.regex)
    if options.threads:
        return print(checks.test_threads(options.regex))
    if not (options.host or options.checks or options.reach or options.aarch64 or options.windows):
        return hosts.test_here(options.regex)
    if options.regex and not options.host:
        raise Failure("--checks, --reach, --aarch64 and --windows take no names of tests")

    stage = Stages(options.required)
    if options.host == "all":
        stage(f"core and MeshLab {meshlab_version()}", hosts.test_here, options.regex)
    for name in hosts.NAMES:
        if name == options.host or options.host == "all" and not hosts.is_here(name):
            stage(name, hosts.test_host, name, options.regex, options.versions)
    if options.checks:
        checks.run_checks(stage, options.nightly)
    if options.reach:
        reach.run_stages(stage)
    for name, test in reach.SYSTEMS.items():
        if options.reach or getattr(options, name):
            stage(name, test)
    return stage.tell()


run_main(main)
