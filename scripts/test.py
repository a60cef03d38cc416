# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds everything and runs the tests. See USAGE below."""

import os
import re
import sys

from checks import checks, sanitized
from environment.files import cache_folder
from environment.messages import Failure, run_main
from environment.packages import meshlab_version
from hosts import hosts, reach
from hosts.results import Results

USAGE = f"""\
./test [REGEX...]              tests the core, and the plugins in the MeshLab installed here
./test --host HOST [REGEX...]  tests the plugins in {' '.join(hosts.SUITES)} or pymeshlab, or all of them and the core
    --required                 a host that cannot be set up, and others' programs that tests miss, are failures instead of
                               being skipped
./test --checks                clang's warnings, static analysis, the core under sanitizers, its coverage, some fuzzing;
                               with --host, after the tests there
./test --fuzz SECONDS          fuzzing alone
./test --sanitized [REGEX...]  GUI tests with plugins compiled with sanitizers: {' '.join(sanitized.GUI_TESTS)}
./test --reach                 the portable plugins in MeshLabs that did not build them, the packages, and the wheel
./test --threads [FILTER...]   tests of the core that use several threads, or those of GoogleTest's FILTER, under ThreadSanitizer

Only tests whose names match a REGEX run; without one all but "wheel", which takes minutes. A MeshLab of another version
than the one installed here runs in a root: the release of Debian that packages it, kept in {cache_folder()}/roots, made as
root by debootstrap.
"""


def main():
    host, required, with_checks, with_reach, words = None, False, False, False, sys.argv[1:]
    while words and words[0].startswith("-"):
        word = words.pop(0)
        if word in ("-h", "--help"):
            print(USAGE, end="")
            return
        if word == "--host":
            host = words.pop(0) if words else ""
            if host not in (*hosts.NAMES, "all"):
                raise Failure(f"--host needs one of {' '.join(hosts.NAMES)} all")
        elif word == "--checks":
            with_checks = True
        elif word == "--fuzz":
            if len(words) != 1 or not re.fullmatch("[1-9][0-9]*", words[0]):
                raise Failure("--fuzz needs a number of seconds, and nothing else")
            return checks.fuzz_alone(words[0])
        elif word == "--sanitized":
            return sanitized.test_gui(words)
        elif word == "--threads":
            return sanitized.test_threads(words)
        elif word == "--reach":
            with_reach = True
        elif word == "--required":
            required = True
            os.environ["LAPLACIAN_LINES_REQUIRED"] = "true"  # by tests that would be skipped
        else:
            raise Failure(f"unknown option {word}; see ./test --help")
    if not (host or with_checks or with_reach):
        return hosts.test_here(words)
    if words and not host:
        raise Failure("--checks and --reach take no names of tests")

    results = Results(required)
    if host == "all":
        results.stage(f"core and MeshLab {meshlab_version()}", hosts.test_here, words)
    for name in hosts.NAMES if host == "all" else [host] if host else []:
        if not (host == "all" and hosts.is_here(name)):
            results.stage(name, hosts.test_host, name, words)
    if with_checks:
        checks.run_checks(results)
    if with_reach:
        reach.run_stages(results)
    return results.tell()


run_main(main)
