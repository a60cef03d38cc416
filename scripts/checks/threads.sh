# SPDX-License-Identifier: GPL-3.0-or-later
# The core's threads under ThreadSanitizer.

require checks/clang_build environment/build environment/messages

THREADED_TESTS=('ThreadPool.*' '*NumberOfThreads*' '*ThreadsAtOnce*' '*ByManyThreads*' 'LineVisibility.AgreesWithTheExactTorus'
    'Progress.*' 'Cancelled.*' '*BuildingProgress.RisesFromZeroToOne*') # without any named
UNTHREADED_TESTS='*InAForkedProcess' # the sanitizer refuses to start threads there

threads_folder() {
    printf '%s/threads\n' "$(build_folder "$1")"
}

# test_threads CHECKOUT [GTEST_FILTER...]
test_threads() {
    local checkout=$1 folder filter
    shift
    folder=$(threads_folder "$checkout")
    (($#)) || set -- "${THREADED_TESTS[@]}"
    # the tests have an operator new of their own, and so has the sanitizer's library
    build_with_clang "$checkout" "$folder" thread core_tests -- -DCMAKE_EXE_LINKER_FLAGS=-Wl,-z,muldefs
    filter=$(IFS=: && printf '%s' "$*")
    say "running tests of the core under ThreadSanitizer"
    LAPLACIAN_LINES_THREADS=4 TSAN_OPTIONS="halt_on_error=1" \
        quietly "$folder/tests.log" "$folder/tests/core/core_tests" --gtest_brief=1 --gtest_filter="$filter:-$UNTHREADED_TESTS" ||
        fail "a race or a failed test is in $folder/tests.log"
    ! grep -q 'PASSED.* 0 tests' "$folder/tests.log" || fail "there is no such test: $*"
    tail -n 1 "$folder/tests.log" >&2
}
