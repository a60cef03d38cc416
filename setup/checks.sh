# SPDX-License-Identifier: GPL-3.0-or-later
# What tests alone do not see: warnings of another compiler, static analysis, sanitizers, coverage, fuzzing.

CHECK_PACKAGES=(clang llvm libomp-dev cppcheck)
SANITIZERS=fuzzer-no-link,address,undefined,float-cast-overflow
LEAST_COVERAGE=95 # percent of the core's lines
# Tests of accuracy and of many options on large meshes take minutes under sanitizers, and the code that they run is run
# by others too.
SLOW_UNDER_SANITIZERS='*WithAnyOptions*:Convergence*:RealModel*:Models/*'
FUZZ_PARTS=(precompute extract)
FUZZ_SECONDS=60

checks_folder() {
    printf '%s/checks\n' "$(build_folder "$1")"
}

# build_checks CHECKOUT TARGETS...: by clang, with sanitizers and coverage
build_checks() {
    local checkout=$1 folder
    folder=$(checks_folder "$1")
    shift
    ensure_toolchain "${TEST_PACKAGES[@]}" "${CHECK_PACKAGES[@]}"
    say "building with clang and sanitizers"
    local LAPLACIAN_LINES_BUILD=$folder
    configure "$checkout" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=None \
        "-DCMAKE_CXX_FLAGS=-O1 -gline-tables-only -fprofile-instr-generate -fcoverage-mapping" \
        -DLAPLACIAN_LINES_BUILD_TESTS=ON -DLAPLACIAN_LINES_WERROR=ON "-DLAPLACIAN_LINES_SANITIZE=$SANITIZERS"
    compile "$checkout" "$@"
}

# The suppressions say why.
check_statically() {
    say "static analysis"
    (cd "$1" && cppcheck --quiet --error-exitcode=1 --std=c++17 --language=c++ -j "$(nproc)" \
        --enable=warning,performance,portability --suppressions-list=setup/cppcheck_suppressions.txt \
        -I laplacian_lines/include -I laplacian_lines/src \
        laplacian_lines filter_laplacian_lines decorate_laplacian_lines meshlab_host headless_host) ||
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

# run_shard FOLDER NUMBER: a part of the core's tests
run_shard() {
    local folder=$1
    GTEST_TOTAL_SHARDS=$(nproc) GTEST_SHARD_INDEX=$2 OMP_NUM_THREADS=2 ASAN_OPTIONS=allocator_may_return_null=1 \
        LLVM_PROFILE_FILE="$folder/profile/%m-$2.profraw" \
        "$folder/tests/core/core_tests" --gtest_brief=1 --gtest_filter="-$SLOW_UNDER_SANITIZERS" >"$folder/shard$2.log" 2>&1 ||
        {
            tail -n 40 "$folder/shard$2.log" >&2
            return 1
        }
}

run_sanitized() {
    local folder
    folder=$(checks_folder "$1")
    rm -rf "$folder/profile"
    say "running the core's tests under sanitizers"
    in_parallel run_shard "$folder" -- $(seq 0 $(($(nproc) - 1))) || fail "a test failed under sanitizers; the logs are $folder/shard*.log"
    LLVM_PROFILE_FILE="$folder/profile/%m-memory.profraw" OMP_NUM_THREADS=3 ASAN_OPTIONS=detect_leaks=0 \
        "$folder/tests/core/out_of_memory" allocations >"$folder/memory.log" 2>&1 ||
        { tail -n 40 "$folder/memory.log" >&2; fail "running out of memory was not survived"; }
}

# Lines of laplacian_lines/ that these tests have run.
check_coverage() {
    local folder covered
    folder=$(checks_folder "$1")
    llvm-profdata merge -sparse "$folder"/profile/*.profraw -o "$folder/profile/all.profdata"
    llvm-cov report "$folder/tests/core/core_tests" -object "$folder/tests/core/out_of_memory" \
        -instr-profile "$folder/profile/all.profdata" "$(readlink -f "$1")/laplacian_lines" >"$folder/coverage.txt" 2>/dev/null
    covered=$(awk '$1 == "TOTAL" { sub("%", "", $10); print $10 }' "$folder/coverage.txt")
    say "$covered % of the core's lines are covered (file by file: $folder/coverage.txt)"
    awk -v covered="$covered" -v least="$LEAST_COVERAGE" 'BEGIN { exit !(covered >= least) }' ||
        fail "at least $LEAST_COVERAGE % of the core's lines have to be covered by tests"
}

# fuzz_part CHECKOUT SECONDS PART
fuzz_part() {
    local folder work
    folder=$(checks_folder "$1") work=$(checks_folder "$1")/fuzz/$3
    mkdir -p "$work/corpus"
    ASAN_OPTIONS=detect_leaks=0 OMP_NUM_THREADS=1 LLVM_PROFILE_FILE=/dev/null \
        "$folder/tests/fuzz/fuzz_$3" -max_total_time="$2" -max_len=800 -len_control=0 -timeout=60 -rss_limit_mb=3000 \
        -artifact_prefix="$work/" -print_final_stats=1 "$work/corpus" "$1/tests/fuzz/corpus/$3" >"$work/log" 2>&1 ||
        {
            grep -E 'ERROR|runtime error|^[a-z]+: |Test unit written' "$work/log" >&2 || tail -n 20 "$work/log" >&2
            return 1
        }
    say "fuzzing $3: $(awk '$1 == "stat::number_of_executed_units:" { print $2 }' "$work/log") inputs"
}

# fuzz CHECKOUT SECONDS: all parts at once; what they learn is kept in the build folder
fuzz() {
    build_checks "$1" fuzz_precompute fuzz_extract
    say "fuzzing for $2 seconds"
    in_parallel fuzz_part "$1" "$2" -- "${FUZZ_PARTS[@]}" ||
        fail "an input did harm: copy the file named above to tests/fuzz/found, where a test runs it, and mend the code"
}

check_all() {
    build_checks "$1" core_tests out_of_memory fuzz_precompute fuzz_extract
    check_statically "$1"
    run_sanitized "$1"
    check_coverage "$1"
    fuzz "$1" "$FUZZ_SECONDS"
}
