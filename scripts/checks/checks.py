# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests alone do not see, one check after the other: static analysis; the tests of the core and of the readers of
meshes under sanitizers, and which of its lines they run; fuzzing; meshes of millions of triangles. Each check returns
what is worth telling about its success."""

import os
import re
import shutil

from checks.clang_build import PACKAGES, build_checks, checks_folder
from environment import packages
from environment.build import CHECKOUT, build_folder, build_targets, processors
from environment.files import cache_folder
from environment.messages import Failure, quietly, run, run_together, say, show_end

LEAST_COVERAGE = 97  # percent of the core's lines
# Under sanitizers these take minutes: accuracy, many meshes, triangles, options or threads. Others run the same code.
SLOW_UNDER_SANITIZERS = """*WithAnyOptions* *Converge* *Guarantee* RealModel* Models/* Meshes/PlainComparison* *TorusLines*
    *Monotone* *Large* *KindsOnSurface* *ClosedOutlines* PlainSight.* ExactPointLight.* EndlessSum.* Determinism.*
    SummationChoice.FollowsThePredictedCost Borders.CorrectionHelpsMoreOnFinerMeshes
    *.DoNotDependOnTheNumberOfThreads *.DoesNotDependOnTheNumberOfThreads
    *FiniteFromAnyEye/book *FiniteFromAnyEye/cut_star *FiniteFromAnyEye/triangle_soup""".split()
FUZZ_GROUPS = ("precompute", "extract"), ("ply", "stl", "obj", "off")
FUZZ_SECONDS, NIGHTLY_FUZZ_SECONDS = 10, 300  # of each group; inputs that were found once are tests
CHECKED = ["core_tests", "out_of_memory", "mesh_files_tests", "write_seeds",
           *(f"fuzz_{part}" for group in FUZZ_GROUPS for part in group)]
CPP_FOLDERS = """laplacian_lines line_drawing line_renderer filter_laplacian_lines decorate_laplacian_lines meshlab_host
    programs/drawing_program programs/headless_host""".split()


def run_checks(results, nightly):
    """By night, clang builds all rooms, not only what runs here, and slow checks run."""
    results.stage("static analysis", check_statically)
    if not results.stage("clang's warnings", build_checks, *([] if nightly else CHECKED)):
        return
    results.stage("sanitizers", check_sanitized)
    results.stage("coverage of the core", check_coverage)
    results.stage("fuzzing", check_by_fuzzing, NIGHTLY_FUZZ_SECONDS if nightly else FUZZ_SECONDS)
    if nightly:
        results.stage("large meshes", check_large_meshes)


def is_shell(file):
    with open(file, "rb") as text:
        return re.match(rb"#!.*\b(ba)?sh\b", text.readline()) is not None


def check_statically():
    """cppcheck of all C++, with reasons for suppressions; shellcheck of all shell scripts; that Python's compile."""
    say("static analysis")
    packages.ensure_packages(*PACKAGES)
    kept = cache_folder() / "cppcheck"  # what has not changed is not analysed again
    kept.mkdir(parents=True, exist_ok=True)
    if run(["cppcheck", f"--cppcheck-build-dir={kept}", "--quiet", "--error-exitcode=1", "--std=c++17", "--language=c++", "-j", str(processors()),
            "--enable=warning,performance,portability", "--suppressions-list=scripts/checks/cppcheck_suppressions.txt",
            "-I", "laplacian_lines/include", "-I", "laplacian_lines/src", *CPP_FOLDERS], cwd=CHECKOUT, stdout=2) != 0:
        raise Failure("cppcheck found the above: fix it, or say why not in scripts/checks/cppcheck_suppressions.txt")
    files = [CHECKOUT / name for name in ("run", "test", "bench", ".ci/run")]
    files += [file for name in ("scripts", "programs", "tests") for file in (CHECKOUT / name).rglob("*")
              if file.is_file()]
    if run(["shellcheck", *filter(is_shell, files)], cwd=CHECKOUT, stdout=2) != 0:
        raise Failure("shellcheck found the above")
    for file in files:
        if file.suffix == ".py":
            try:
                compile(file.read_text(), file, "exec")
            except SyntaxError as error:
                raise Failure(f"{file}: {error}") from None


def check_sanitized():
    folder = checks_folder()
    shutil.rmtree(folder / "profile", ignore_errors=True)
    for log in folder.glob("shard*.log"):
        log.unlink()
    say("running the core's tests under sanitizers")
    shards = 2 * processors()  # more than processors, for some take longer

    def job(log, profile, program, *words, **environment):
        options = {"env": {**os.environ, "LLVM_PROFILE_FILE": profile, **environment}}
        return folder / log, [folder / "tests" / program, *words], options

    jobs = [job("memory.log", f"{folder}/profile/%m-memory.profraw", "core/out_of_memory", "allocations",
                LAPLACIAN_LINES_THREADS="3"),
            job("shard-files.log", "/dev/null", "mesh_files/mesh_files_tests", "--gtest_brief=1")]
    jobs += [job(f"shard{number}.log", f"{folder}/profile/%m-{number}.profraw", "core/core_tests", "--gtest_brief=1",
                 f"--gtest_filter=-{':'.join(SLOW_UNDER_SANITIZERS)}", GTEST_TOTAL_SHARDS=str(shards),
                 GTEST_SHARD_INDEX=str(number),
                 LAPLACIAN_LINES_THREADS="2", ASAN_OPTIONS="allocator_may_return_null=1") for number in range(shards)]
    failed = [log for (log, *_), succeeded in zip(jobs, run_together(jobs)) if not succeeded]
    for log in failed:
        show_end(log)
    if failed:
        raise Failure(f"a test failed under sanitizers; the logs are {' '.join(map(str, failed))}")
    counts = [int(count) for log in folder.glob("shard*.log")
              for count in re.findall(r"(\d+) tests? from .*ran", log.read_text())]
    return f"{sum(counts) + 1} tests"


def check_coverage():
    """Lines of laplacian_lines/ that check_sanitized() has run."""
    folder = checks_folder()
    profile = folder / "profile/all.profdata"
    merged = run(["llvm-profdata", "merge", "-sparse", *(folder / "profile").glob("*.profraw"), "-o", profile],
                 stdout=2)
    with (folder / "coverage.txt").open("w") as table, (folder / "coverage.log").open("w") as log:
        if merged or run(["llvm-cov", "report", folder / "tests/core/core_tests", "-object",
                          folder / "tests/core/out_of_memory",
                          "-compilation-dir", folder / "laplacian_lines", "-instr-profile", profile,
                          (CHECKOUT / "laplacian_lines").resolve()], stdout=table, stderr=log):
            raise Failure("the coverage could not be counted")
    say(f"coverage, file by file: {folder / 'coverage.txt'}")
    (total,) = (line.split() for line in (folder / "coverage.txt").read_text().splitlines() if line.startswith("TOTAL"))
    covered = float(total[9].rstrip("%"))
    if not covered >= LEAST_COVERAGE:
        raise Failure(f"only {covered} % of the core's lines are covered by tests, less than {LEAST_COVERAGE} %")
    return f"{covered} % of the lines"


def fuzz_job(part, seconds, corpus):
    """Inputs made up by libFuzzer; interesting new ones go to CORPUS/PART."""
    folder = checks_folder()
    work = folder / "fuzz" / part
    for place in (work, corpus / part):
        place.mkdir(parents=True, exist_ok=True)
    environment = {"ASAN_OPTIONS": "detect_leaks=0", "LAPLACIAN_LINES_THREADS": "1", "LLVM_PROFILE_FILE": "/dev/null"}
    command = [folder / f"tests/fuzz/fuzz_{part}", f"-max_total_time={seconds}", "-max_len=4096", "-len_control=0",
               "-seed=1", "-timeout=60",
               "-rss_limit_mb=3000", f"-artifact_prefix={work}/", "-print_final_stats=1", corpus / part,
               folder / "fuzz/seeds" / part,
               CHECKOUT / "tests/fuzz/found"]
    return work / "log", command, {"env": {**os.environ, **environment}}


def found_by(part, log, succeeded):
    text = log.read_text(errors="replace")
    if not succeeded:
        lines = re.findall("(?m)^.*(?:ERROR|runtime error|Test unit written).*$|^[a-z]+: .*$",
                           text) or text.splitlines()[-20:]
        os.write(2, ("\n".join(lines) + "\n").encode())
        raise Failure("an input broke something: copy the file named above to tests/fuzz/found, where a test runs it, and fix the code")
    units, features = ((re.findall(pattern, text) or [0])[-1]
                       for pattern in (r"stat::number_of_executed_units:\s*(\d+)", r" ft: (\d+)"))
    return f"{part}: {units} inputs, {features} features"


def fuzz(seconds, corpus):
    """All parts at once, from fixed seeds and the corpus."""
    seeds = checks_folder() / "fuzz/seeds"
    shutil.rmtree(seeds, ignore_errors=True)
    if run([checks_folder() / "tests/fuzz/write_seeds", seeds], env={**os.environ, "LLVM_PROFILE_FILE": "/dev/null"}):
        raise Failure("the fuzzers' seeds could not be written")
    say(f"fuzzing twice for {seconds} seconds")
    found = []
    for group in FUZZ_GROUPS:
        jobs = [fuzz_job(part, seconds, corpus) for part in group]
        found += [found_by(part, log, succeeded) for part, (log, *_), succeeded in zip(group, jobs, run_together(jobs))]
    return "; ".join(found)


def check_by_fuzzing(seconds):
    """Forgets what it learnt, so that runs are alike."""
    corpus = checks_folder() / "fuzz/new"
    shutil.rmtree(corpus, ignore_errors=True)
    return fuzz(seconds, corpus)


def fuzz_alone(seconds):
    """Keeps what it learnt in the build folder."""
    build_checks(*(f"fuzz_{part}" for group in FUZZ_GROUPS for part in group), "write_seeds")
    print(fuzz(seconds, checks_folder() / "fuzz/corpus"))


def check_large_meshes():
    """The tests of meshes that take seconds and up to 2.2 GB."""
    build, log = build_folder(), build_folder() / "large_meshes.log"
    packages.ensure_packages(*packages.CORE, *packages.TEST)
    build_targets("core_tests", preset="tests")
    say("computing large meshes")
    if not quietly(log, [build / "tests/core/core_tests", "--gtest_filter=Meshes/Large.*"],
                   env={**os.environ, "LAPLACIAN_LINES_LARGE": "1"}):
        raise Failure(f"a large mesh took too much time or memory, or was not refused; the log is {log}")
    return re.findall(r"PASSED\s*\] (\d+)", log.read_text())[0] + " meshes"
