# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks beside the tests: static analysis, and one build by clang, with its warnings as errors, whose tests run under
sanitizers, are counted for coverage and are fuzzed; MeshLab with such plugins; threads under ThreadSanitizer."""

import os
import pathlib
import platform
import re
import shutil

from checks.static import check_statically
from environment import packages
from environment.build import CHECKOUT, build_folder, build_targets, ctest, processors
from environment.messages import Failure, output, quietly, run, run_together, say

LEAST_COVERAGE = 97  # percent of the core's lines
# Under sanitizers these take minutes: accuracy, many meshes, triangles, options or threads. Others run the same code.
SLOW_UNDER_SANITIZERS = """*WithAnyOptions* *Converge* *Large* *KindsOnSurface* *ClosedOutlines* CostlySum.* Determinism.*
    *NumberOfThreads""".split()
FUZZED = "core", "ply", "stl", "obj", "off"
FUZZ_SECONDS, NIGHTLY_FUZZ_SECONDS = 20, 600  # of all at once; inputs that were found once are tests
FUZZERS = [*(f"fuzz_{part}" for part in FUZZED), "write_seeds"]
CHECKED = "core_tests", "mesh_files_tests", *FUZZERS
GUI_TESTS = ("gui_filters", "gui_layers", "gui_lines")  # without any named
THREADED_TESTS = """ThreadPool.* *NumberOfThreads* *ThreadsAtOnce* LineVisibility.AgreesWithTheExactTorus
    *InProgress*""".split()  # without any named
UNTHREADED_TESTS = "*InAForkedProcess"  # the sanitizer refuses to start threads there


def run_checks(stage, nightly):
    """By night, clang builds all modules, not only what runs here, and slow checks run."""
    stage("static analysis", check_statically)
    if stage("clang's warnings", build_with_clang, "sanitizers", *([] if nightly else CHECKED)):
        stage("sanitizers", check_sanitized)
        stage("coverage of the core", check_coverage)
        stage("fuzzing", fuzz, NIGHTLY_FUZZ_SECONDS if nightly else FUZZ_SECONDS, "new")
    if nightly:
        stage("large meshes", check_large_meshes)
        stage("GUI under sanitizers", test_gui, [])
        stage("threads", test_threads, [])


def checks_folder(preset="sanitizers"):
    return build_folder() / preset


def build_with_clang(preset, *targets):
    """All targets if none is named. Warnings are errors."""
    # for ccache, which would otherwise hash this file's name instead of its contents
    ignored = CHECKOUT / "scripts/cmake/sanitizer_ignorelist.txt"
    build_targets(*targets, preset=preset, extra_packages=[*packages.TEST, *packages.CHECKS], build=checks_folder(preset),
                  CCACHE_IGNOREOPTIONS="-fsanitize-ignorelist=*", CCACHE_EXTRAFILES=str(ignored))


def check_sanitized():
    folder, shards = checks_folder(), 2 * processors()  # more than processors, for some take longer
    shutil.rmtree(folder / "profile", ignore_errors=True)

    def job(log, profile, program, *words, **environment):
        options = {"env": {**os.environ, "LLVM_PROFILE_FILE": profile, **environment}}
        return folder / log, [folder / "tests" / program, *words], options

    jobs = [job("files.log", "/dev/null", "mesh_files/mesh_files_tests", "--gtest_brief=1")]
    jobs += [job(f"shard{number}.log", f"{folder}/profile/%m-{number}.profraw", "core/core_tests", "--gtest_brief=1",
                 f"--gtest_filter=-{':'.join(SLOW_UNDER_SANITIZERS)}", GTEST_TOTAL_SHARDS=str(shards),
                 GTEST_SHARD_INDEX=str(number), LAPLACIAN_LINES_THREADS="2", ASAN_OPTIONS="allocator_may_return_null=1")
             for number in range(shards)]
    failed = [str(log) for (log, *_), succeeded in zip(jobs, run_together(jobs)) if not succeeded]
    if failed:
        os.write(2, "\n".join(pathlib.Path(failed[0]).read_text(errors="replace").splitlines()[-40:]).encode())
        raise Failure(f"a test failed under sanitizers; the logs are {' '.join(failed)}")
    counts = [int(count) for log, *_ in jobs for count in re.findall(r"(\d+) tests? from .*ran", log.read_text())]
    return f"{sum(counts)} tests"


def check_coverage():
    """Lines of laplacian_lines/ that check_sanitized() has run."""
    folder = checks_folder()
    profile, table = folder / "profile/all.profdata", folder / "coverage.txt"
    merged = run(["llvm-profdata", "merge", "-sparse", *(folder / "profile").glob("*.profraw"), "-o", profile], stdout=2)
    with table.open("w") as text, (folder / "coverage.log").open("w") as log:
        if merged or run(["llvm-cov", "report", folder / "tests/core/core_tests", "-compilation-dir", folder / "laplacian_lines",
                          "-instr-profile", profile, (CHECKOUT / "laplacian_lines").resolve()], stdout=text, stderr=log):
            raise Failure("the coverage could not be counted")
    covered = float(re.search(r"^TOTAL.*$", table.read_text(), re.M)[0].split()[9].rstrip("%"))
    if not covered >= LEAST_COVERAGE:
        raise Failure(f"only {covered} % of the core's lines are covered by tests, less than {LEAST_COVERAGE} %: {table}")
    return f"{covered} % of the lines"


def fuzz(seconds, corpus):
    """Fuzzes from fixed seeds and the corpus of this name, to which libFuzzer adds interesting inputs; "new" is cleared first,
    so that runs are alike."""
    folder, programs, jobs, counts = checks_folder() / "fuzz", checks_folder() / "tests/fuzz", [], []
    options = {"env": {**os.environ, "ASAN_OPTIONS": "detect_leaks=0", "LAPLACIAN_LINES_THREADS": "1",
                       "LLVM_PROFILE_FILE": "/dev/null"}}
    for name in ("seeds", "new"):
        shutil.rmtree(folder / name, ignore_errors=True)
    if run([programs / "write_seeds", folder / "seeds"], **options):
        raise Failure("the fuzzers' seeds could not be written")
    say(f"fuzzing for {seconds} seconds")
    for part in FUZZED:
        (folder / corpus / part).mkdir(parents=True, exist_ok=True)
        jobs.append((folder / part / "log", [
            programs / f"fuzz_{part}", f"-max_total_time={seconds}", "-max_len=16384", "-len_control=0", "-seed=1", "-timeout=60",
            "-rss_limit_mb=3000", f"-artifact_prefix={folder / part}/", "-print_final_stats=1", folder / corpus / part,
            folder / "seeds" / part, CHECKOUT / "tests/fuzz/found"], options))
    for part, (log, *_), succeeded in zip(FUZZED, jobs, run_together(jobs)):
        text = log.read_text(errors="replace")
        if not succeeded:
            lines = re.findall("(?m)^.*(?:ERROR|runtime error|Test unit written).*$|^[a-z]+: .*$", text) or text.splitlines()[-20:]
            os.write(2, ("\n".join(lines) + "\n").encode())
            raise Failure("an input broke something: copy the file named above to tests/fuzz/found, where a test runs it, and fix the code")
        counts.append(f"{part}: {re.findall(r'stat::number_of_executed_units: *([0-9]+)', text)[-1]} inputs")
    return "; ".join(counts)


def fuzz_alone(seconds):
    """Keeps its corpus in the build folder."""
    build_with_clang("sanitizers", *FUZZERS)
    return fuzz(seconds, "corpus")


def core_tests(build, names, **environment):
    """Runs these tests of the core; returns GoogleTest's last line."""
    log = build / "core_tests.log"
    if not quietly(log, [build / "tests/core/core_tests", "--gtest_brief=1", f"--gtest_filter={names}"],
                   env={**os.environ, **environment}):
        raise Failure(f"a test has failed; the log is {log}")
    passed = log.read_text().splitlines()[-1]
    if not re.match(r"\[  PASSED  \] [1-9]", passed):
        raise Failure(f"no test, or not all, ran of {names}: {passed}")
    return passed


def check_large_meshes():
    """The tests of meshes that take seconds and up to 2.2 GB."""
    build_targets("core_tests", preset="tests", extra_packages=packages.TEST)
    return core_tests(build_folder(), "Meshes/Large.*", LAPLACIAN_LINES_LARGE="1")


def test_gui(regexes):
    """MeshLab with sanitized plugins. malloc_context_size: the allocating function and its caller; MeshLab and Qt lack
    frame pointers for more. DRIVE_SECONDS, for one MeshLab: it is slower, and looking for leaks takes its time."""
    folder = checks_folder()
    reports = folder / "reports"
    packages.ensure_packages(*packages.DISPLAY)
    build_with_clang("sanitizers", "meshlab_tests")
    shutil.rmtree(reports, ignore_errors=True)
    reports.mkdir(parents=True)
    library = output("clang", f"-print-file-name=libclang_rt.asan-{platform.machine()}.so")
    code = run(ctest(folder, "meshlab", regexes or GUI_TESTS), env={
        "DRIVE_SECONDS": "900", **os.environ, "SANITIZER_LIBRARY": library, "LLVM_PROFILE_FILE": "/dev/null",
        "ASAN_OPTIONS": f"log_path={reports}/of:detect_leaks=1:malloc_context_size=2:stack_trace_format='    #%n %f %S %M'",
        "UBSAN_OPTIONS": f"log_path={reports}/of:print_stacktrace=1",
        "LSAN_OPTIONS": "exitcode=0:use_tls=0:print_suppressions=0:suppressions="
                        f"{CHECKOUT}/scripts/checks/leak_suppressions.txt"})
    texts = [file.read_text(errors="replace") for file in reports.iterdir()]
    # leaks of MeshLab, Qt and OpenGL are not ours: only those count that our plugins have allocated
    found = [text for text in texts if re.search("ERROR: AddressSanitizer|runtime error", text)]
    found += [part for text in texts for part in text.split("\n\n")
              if "leak of" in part and re.search(r"lib(filter|decorate)_laplacian_lines\.so", part)]
    if found:
        os.write(2, "\n".join("\n".join(found).splitlines()[:40]).encode())
    if found or code != 0 or not texts:
        raise Failure(f"memory leaked, a test failed, or leaks were not looked for; the reports are in {reports}")


def test_threads(filters):
    """With these filters of GoogleTest."""
    build_with_clang("threads", "core_tests")
    return core_tests(checks_folder("threads"), f"{':'.join(filters or THREADED_TESTS)}:-{UNTHREADED_TESTS}",
                      LAPLACIAN_LINES_THREADS="4", TSAN_OPTIONS="halt_on_error=1")
