# SPDX-License-Identifier: GPL-3.0-or-later
# What tests alone do not see: warnings of another compiler, static analysis, sanitizers, coverage, fuzzing, and meshes
# of millions of triangles.
# Each check_... prints on stdout what is worth telling about its success.

CHECK_PACKAGES=(clang libclang-rt-dev llvm libomp-dev cppcheck)
SANITIZERS=address,undefined,float-cast-overflow
LEAST_COVERAGE=95 # percent of the core's lines
# Tests of accuracy, of many meshes or options, and of many threads take minutes under sanitizers. Others run the same
# code.
SLOW_UNDER_SANITIZERS=('*WithAnyOptions*' '*Converge*' '*Guarantee*' 'RealModel*' 'Models/*' 'Meshes/PlainComparison*'
    '*TorusLines*' '*Monotone*' '*Large*'
    'ExactPointLight.*' 'SummationChoice.FollowsThePredictedCost' 'EndlessSum.*'
    'Borders.CorrectionHelpsMoreOnFinerMeshes' 'Determinism.*' '*.DoNotDependOnTheNumberOfThreads'
    '*.DoesNotDependOnTheNumberOfThreads' '*FiniteFromAnyEye/book' '*FiniteFromAnyEye/cut_star')
FUZZ_PARTS=(precompute extract)
FUZZ_SECONDS=150

checks_folder() {
    printf '%s/checks\n' "$(build_folder "$1")"
}

# build_with_clang CHECKOUT FOLDER SANITIZERS TARGETS... [-- CMAKE_OPTIONS...]: warnings are errors
build_with_clang() {
    local checkout=$1 LAPLACIAN_LINES_BUILD=$2 sanitizers=$3 targets=()
    shift 3
    while (($#)) && [[ $1 != -- ]]; do
        targets+=("$1")
        shift
    done
    ensure_toolchain "${TEST_PACKAGES[@]}" "${CHECK_PACKAGES[@]}"
    say "building with clang and the sanitizers $sanitizers"
    configure "$checkout" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=None \
        "-DCMAKE_CXX_FLAGS=-O1 -gline-tables-only" -DLAPLACIAN_LINES_BUILD_TESTS=ON -DLAPLACIAN_LINES_WERROR=ON \
        "-DLAPLACIAN_LINES_SANITIZE=$sanitizers" "${@:2}"
    compile "$checkout" "${targets[@]}"
}

# build_checks CHECKOUT TARGETS...
build_checks() {
    build_with_clang "$1" "$(checks_folder "$1")" "$SANITIZERS" "${@:2}" -- -DLAPLACIAN_LINES_COUNTERS=ON
}

# The suppressions say why.
check_statically() {
    say "static analysis"
    ensure_packages "${CHECK_PACKAGES[@]}"
    (cd "$1" && cppcheck --quiet --error-exitcode=1 --std=c++17 --language=c++ -j "$(nproc)" \
        --enable=warning,performance,portability --suppressions-list=setup/cppcheck_suppressions.txt \
        -I laplacian_lines/include -I laplacian_lines/src \
        laplacian_lines line_renderer filter_laplacian_lines decorate_laplacian_lines meshlab_host headless_host >&2) ||
        fail "cppcheck has found what is above: mend it, or tell why not in setup/cppcheck_suppressions.txt"
}

# in_parallel COMMAND ARGS -- VALUES...: COMMAND ARGS VALUE for all values at once; fails if one does
in_parallel() {
    local command=() jobs=() job failed=0
    while [[ $1 != -- ]]; do
        command+=("$1")
        shift
    done
    shift
    for job in "$@"; do
        "${command[@]}" "$job" &
        jobs+=($!)
    done
    for job in "${jobs[@]}"; do
        wait "$job" || failed=1
    done
    return "$failed"
}

# run_shard CHECKOUT NUMBER: a part of the core's tests. OpenMP's library loses some memory of its own at times. With two
# places of each allocation kept, malloc and its caller, only what the library itself has asked for is suppressed.
run_shard() {
    local folder
    folder=$(checks_folder "$1")
    GTEST_TOTAL_SHARDS=$(nproc) GTEST_SHARD_INDEX=$2 OMP_NUM_THREADS=2 OMP_WAIT_POLICY=passive \
        ASAN_OPTIONS=allocator_may_return_null=1:malloc_context_size=2 \
        LSAN_OPTIONS="suppressions=$1/setup/leak_suppressions.txt:print_suppressions=0" \
        LLVM_PROFILE_FILE="$folder/profile/%m-$2.profraw" \
        quietly "$folder/shard$2.log" "$folder/tests/core/core_tests" --gtest_brief=1 \
        --gtest_filter="-$(IFS=: && printf '%s' "${SLOW_UNDER_SANITIZERS[*]}")"
}

check_sanitized() {
    local folder
    folder=$(checks_folder "$1")
    rm -rf "$folder/profile"
    say "running the core's tests under sanitizers"
    in_parallel run_shard "$1" -- $(seq 0 $(($(nproc) - 1))) ||
        fail "a test failed under sanitizers; the logs are $folder/shard*.log"
    LLVM_PROFILE_FILE="$folder/profile/%m-memory.profraw" OMP_NUM_THREADS=3 OMP_WAIT_POLICY=passive \
        quietly "$folder/memory.log" "$folder/tests/core/out_of_memory" allocations ||
        fail "running out of memory was not survived; the log is $folder/memory.log"
    awk '/test suites? ran/ { sum += $2 } END { print sum + 1 " tests" }' "$folder"/shard*.log
}

# Lines of laplacian_lines/ that check_sanitized has run.
check_coverage() {
    local folder covered
    folder=$(checks_folder "$1")
    {
        llvm-profdata merge -sparse "$folder"/profile/*.profraw -o "$folder/profile/all.profdata" >&2 &&
            llvm-cov report "$folder/tests/core/core_tests" -object "$folder/tests/core/out_of_memory" \
                -instr-profile "$folder/profile/all.profdata" "$(readlink -f "$1")/laplacian_lines" \
                >"$folder/coverage.txt" 2>"$folder/coverage.log"
    } || fail "the coverage could not be counted"
    covered=$(awk '$1 == "TOTAL" { sub("%", "", $10); print $10 }' "$folder/coverage.txt")
    say "coverage, file by file: $folder/coverage.txt"
    awk -v covered="$covered" -v least="$LEAST_COVERAGE" 'BEGIN { exit !(covered >= least) }' ||
        fail "only $covered % of the core's lines are covered by tests, less than $LEAST_COVERAGE %"
    printf '%s %% of the lines\n' "$covered"
}

# fuzz_part CHECKOUT SECONDS CORPUS PART: new inputs of interest go to CORPUS/PART
fuzz_part() {
    local folder corpus=$3/$4 work
    folder=$(checks_folder "$1") work=$(checks_folder "$1")/fuzz/$4
    mkdir -p "$work" "$corpus"
    ASAN_OPTIONS=detect_leaks=0 OMP_NUM_THREADS=1 LLVM_PROFILE_FILE=/dev/null \
        "$folder/tests/fuzz/fuzz_$4" -max_total_time="$2" -max_len=4096 -len_control=0 -seed=1 -timeout=60 \
        -rss_limit_mb=3000 -artifact_prefix="$work/" -print_final_stats=1 \
        "$corpus" "$folder/fuzz/seeds/$4" "$1/tests/fuzz/found" >"$work/log" 2>&1 ||
        {
            grep -E 'ERROR|runtime error|^[a-z]+: |Test unit written' "$work/log" >&2 || tail -n 20 "$work/log" >&2
            return 1
        }
    awk -v part="$4" '/ cov: / { for (i = 1; i < NF; ++i) if ($i == "ft:") features = $(i + 1) }
        $1 == "stat::number_of_executed_units:" { units = $2 }
        END { print part ": " units " inputs, " features " features" }' "$work/log"
}

# fuzz CHECKOUT SECONDS CORPUS: all parts at once, from seeds that are always the same and from the CORPUS
fuzz() {
    local seeds
    seeds=$(checks_folder "$1")/fuzz/seeds
    rm -rf "$seeds"
    LLVM_PROFILE_FILE=/dev/null "$(checks_folder "$1")/tests/fuzz/write_seeds" "$seeds" ||
        fail "the fuzzers' seeds could not be written"
    say "fuzzing for $2 seconds"
    in_parallel fuzz_part "$1" "$2" "$3" -- "${FUZZ_PARTS[@]}" ||
        fail "an input did harm: copy the file named above to tests/fuzz/found, where a test runs it, and mend the code"
}

# Forgets what it has learnt, so that it does much the same each time.
check_by_fuzzing() {
    local corpus found
    corpus=$(checks_folder "$1")/fuzz/new
    rm -rf "$corpus"
    found=$(fuzz "$1" "$FUZZ_SECONDS" "$corpus") || return 1
    printf '%s\n' "${found//$'\n'/; }"
}

# fuzz_alone CHECKOUT SECONDS: what it learns is kept in the build folder for the next time
fuzz_alone() {
    build_checks "$1" fuzz_precompute fuzz_extract write_seeds
    fuzz "$1" "$2" "$(checks_folder "$1")/fuzz/corpus"
}

# The tests of meshes that take seconds and up to 2.2 GB.
check_large_meshes() {
    local build log
    build=$(build_folder "$1") log=$(build_folder "$1")/large_meshes.log
    ensure_packages "${CORE_PACKAGES[@]}" "${TEST_PACKAGES[@]}"
    configure "$1" -DLAPLACIAN_LINES_BUILD_TESTS=ON -DLAPLACIAN_LINES_WERROR=ON
    compile "$1" core_tests
    say "computing large meshes"
    LAPLACIAN_LINES_LARGE=1 quietly "$log" "$build/tests/core/core_tests" --gtest_filter='Meshes/Large.*' ||
        fail "a large mesh took too much time or memory, or was not refused; the log is $log"
    awk '/PASSED/ { print $4 " meshes" }' "$log"
}

# run_checks CHECKOUT CONCLUDE: calls CONCLUDE NAME EXIT_CODE REMARK after each
run_checks() {
    run_check "$@" "static analysis" check_statically || true
    run_check "$@" "clang's warnings" build_checks || return 0
    run_check "$@" "sanitizers" check_sanitized || true
    run_check "$@" "coverage of the core" check_coverage || true
    run_check "$@" "fuzzing" check_by_fuzzing || true
    run_check "$@" "large meshes" check_large_meshes || true
}

# run_check CHECKOUT CONCLUDE NAME COMMAND ARGS...
run_check() {
    local remark code=0
    remark=$("$4" "$1" "${@:5}") || code=$?
    "$2" "$3" "$code" "$remark"
    return "$code"
}
