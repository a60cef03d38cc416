# SPDX-License-Identifier: GPL-3.0-or-later
# The tests of the core and of the readers of meshes under sanitizers, and which of its lines they run.

require checks/clang_build environment/in_parallel environment/messages

LEAST_COVERAGE=95 # percent of the core's lines
# Tests of accuracy, of many meshes, triangles or options, and of many threads take minutes under sanitizers. Others run
# the same code.
SLOW_UNDER_SANITIZERS=('*WithAnyOptions*' '*Converge*' '*Guarantee*' 'RealModel*' 'Models/*' 'Meshes/PlainComparison*'
    '*TorusLines*' '*Monotone*' '*Large*' '*KindsOnSurface*' '*ClosedOutlines*' 'PlainSight.*'
    'ExactPointLight.*' 'SummationChoice.FollowsThePredictedCost' 'EndlessSum.*'
    'Borders.CorrectionHelpsMoreOnFinerMeshes' 'Determinism.*' '*.DoNotDependOnTheNumberOfThreads'
    '*.DoesNotDependOnTheNumberOfThreads' '*FiniteFromAnyEye/book' '*FiniteFromAnyEye/cut_star'
    '*FiniteFromAnyEye/triangle_soup')

SHARDS=$((2 * $(nproc))) # more than processors, for some take longer

# run_shard CHECKOUT NUMBER: a part of the core's tests
run_shard() {
    local folder
    folder=$(checks_folder "$1")
    GTEST_TOTAL_SHARDS=$SHARDS GTEST_SHARD_INDEX=$2 LAPLACIAN_LINES_THREADS=2 \
        ASAN_OPTIONS=allocator_may_return_null=1 \
        LLVM_PROFILE_FILE="$folder/profile/%m-$2.profraw" \
        quietly "$folder/shard$2.log" "$folder/tests/core/core_tests" --gtest_brief=1 \
        --gtest_filter="-$(IFS=: && printf '%s' "${SLOW_UNDER_SANITIZERS[*]}")"
}

run_out_of_memory() {
    local folder
    folder=$(checks_folder "$1")
    LLVM_PROFILE_FILE="$folder/profile/%m-memory.profraw" LAPLACIAN_LINES_THREADS=3 \
        quietly "$folder/memory.log" "$folder/tests/core/out_of_memory" allocations || {
        say "running out of memory crashed it; the log is $folder/memory.log"
        return 1
    }
}

run_files() {
    local folder
    folder=$(checks_folder "$1")
    LLVM_PROFILE_FILE=/dev/null quietly "$folder/shard-files.log" "$folder/tests/mesh_files/mesh_files_tests" \
        --gtest_brief=1
}

# run_sanitized CHECKOUT PART: a shard's number, memory, or files
run_sanitized() {
    case $2 in
    memory) run_out_of_memory "$1" ;;
    files) run_files "$1" ;;
    *) run_shard "$@" ;;
    esac
}

check_sanitized() {
    local folder
    folder=$(checks_folder "$1")
    rm -rf "$folder/profile"
    say "running the core's tests under sanitizers"
    rm -f "$folder"/shard*.log
    in_parallel run_sanitized "$1" -- memory files $(seq 0 $((SHARDS - 1))) ||
        fail "a test failed under sanitizers; the logs are $folder/shard*.log"
    awk '/test suites? ran/ { sum += $2 } END { print sum + 1 " tests" }' "$folder"/shard*.log
}

# Lines of laplacian_lines/ that check_sanitized has run.
check_coverage() {
    local folder covered
    folder=$(checks_folder "$1")
    {
        llvm-profdata merge -sparse "$folder"/profile/*.profraw -o "$folder/profile/all.profdata" >&2 &&
            llvm-cov report "$folder/tests/core/core_tests" -object "$folder/tests/core/out_of_memory" \
                -compilation-dir "$folder/laplacian_lines" \
                -instr-profile "$folder/profile/all.profdata" "$(readlink -f "$1")/laplacian_lines" \
                >"$folder/coverage.txt" 2>"$folder/coverage.log"
    } || fail "the coverage could not be counted"
    covered=$(awk '$1 == "TOTAL" { sub("%", "", $10); print $10 }' "$folder/coverage.txt")
    say "coverage, file by file: $folder/coverage.txt"
    awk -v covered="$covered" -v least="$LEAST_COVERAGE" 'BEGIN { exit !(covered >= least) }' ||
        fail "only $covered % of the core's lines are covered by tests, less than $LEAST_COVERAGE %"
    printf '%s %% of the lines\n' "$covered"
}
