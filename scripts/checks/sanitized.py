# SPDX-License-Identifier: GPL-3.0-or-later
"""The GUI's tests with plugins that are compiled with sanitizers, in an ordinary MeshLab; and the core's threads under
ThreadSanitizer."""

import os
import platform
import re
import shutil

from checks.clang_build import build_checks, build_with_clang, checks_folder
from environment import packages
from environment.build import CHECKOUT, build_folder, ctest
from environment.messages import Failure, output, quietly, run, say

GUI_TESTS = ("gui_filter", "gui_edits", "gui_views", "gui_memory", "gui_random_actions")  # without any named
SECONDS = "900"  # for one test: MeshLab is slower, and looking for leaks takes its time
THREADED_TESTS = ("ThreadPool.*", "*NumberOfThreads*", "*ThreadsAtOnce*", "*ByManyThreads*",
                  "LineVisibility.AgreesWithTheExactTorus",
                  "Progress.*", "Cancelled.*", "*BuildingProgress.RisesFromZeroToOne*")  # without any named
UNTHREADED_TESTS = "*InAForkedProcess"  # the sanitizer refuses to start threads there


def test_gui(regexes):
    """malloc_context_size: the allocating function and its caller; MeshLab and Qt lack frame pointers for more."""
    folder = checks_folder()
    reports = folder / "reports"
    packages.ensure_packages(*packages.DISPLAY)
    build_checks("meshlab_tests")
    shutil.rmtree(reports, ignore_errors=True)
    reports.mkdir(parents=True)
    say("running the tests under sanitizers")
    library = output("clang", f"-print-file-name=libclang_rt.asan-{platform.machine()}.so")
    code = run(ctest(folder, "meshlab", "--tests-regex", "|".join(regexes or GUI_TESTS)), env={
        "DRIVE_SECONDS": SECONDS, "RANDOM_SEEDS": "3", **os.environ, "SANITIZER_LIBRARY": library,
        "LLVM_PROFILE_FILE": "/dev/null",
        "ASAN_OPTIONS": f"log_path={reports}/of:detect_leaks=1:malloc_context_size=2:stack_trace_format='    #%n %f %S %M'",
        "UBSAN_OPTIONS": f"log_path={reports}/of:print_stacktrace=1",
        "LSAN_OPTIONS": "exitcode=0:use_tls=0:print_suppressions=0:suppressions="
                        f"{CHECKOUT}/scripts/checks/leak_suppressions.txt"})
    texts = [file.read_text(errors="replace") for file in reports.iterdir()]
    for text in texts:
        if re.search("ERROR: AddressSanitizer|runtime error", text):
            os.write(2, "\n".join(text.splitlines()[:40]).encode())
    # leaks of MeshLab, Qt and OpenGL are not ours: only those count that our plugins have allocated
    leaks = [part for text in texts for part in text.split("\n\n")
             if "leak of" in part and re.search(r"lib(filter|decorate)_laplacian_lines\.so", part)]
    (folder / "leaks.txt").write_text("\n".join(leaks))
    if leaks:
        os.write(2, "\n".join("\n".join(leaks).splitlines()[:40]).encode())
        raise Failure(f"memory leaked; all leaks are in {folder / 'leaks.txt'}")
    if code != 0:
        raise Failure(f"a test failed; the sanitizers' reports are in {reports}")
    if not texts:
        raise Failure("the sanitizers did not look for leaks: there is no report")


def test_threads(filters):
    """Of GoogleTest."""
    folder = build_folder() / "threads"
    build_with_clang(folder, "threads", "core_tests")
    say("running tests of the core under ThreadSanitizer")
    log = folder / "tests.log"
    if not quietly(log, [folder / "tests/core/core_tests", "--gtest_brief=1",
                         f"--gtest_filter={':'.join(filters or THREADED_TESTS)}:-{UNTHREADED_TESTS}"],
                   env={**os.environ, "LAPLACIAN_LINES_THREADS": "4", "TSAN_OPTIONS": "halt_on_error=1"}):
        raise Failure(f"a race or a failed test is in {log}")
    text = log.read_text()
    if re.search("PASSED.* 0 tests", text):
        raise Failure(f"there is no such test: {' '.join(filters)}")
    os.write(2, (text.splitlines()[-1] + "\n").encode())
