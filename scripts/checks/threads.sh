# SPDX-License-Identifier: GPL-3.0-or-later
# The core's threads under ThreadSanitizer.

require checks/clang_build environment/build environment/messages

THREADED_TESTS=('*NumberOfThreads*' '*ThreadsAtOnce*' '*ByManyThreads*' 'LineVisibility.AgreesWithTheExactTorus'
    'Progress.*' 'Cancelled.*' '*BuildingProgress.RisesFromZeroToOne*') # without any named

threads_folder() {
    printf '%s/threads\n' "$(build_folder "$1")"
}

# The part of LLVM that tells the sanitizer what OpenMP waits for; without it, all that threads share is a race.
archer() {
    printf '%s/libarcher.so\n' "$(llvm-config --libdir)"
}

# test_threads CHECKOUT [GTEST_FILTER...]
test_threads() {
    local checkout=$1 folder filter
    shift
    folder=$(threads_folder "$checkout")
    (($#)) || set -- "${THREADED_TESTS[@]}"
    # the tests have an operator new of their own, and so has the sanitizer's library
    build_with_clang "$checkout" "$folder" thread core_tests -- -DCMAKE_EXE_LINKER_FLAGS=-Wl,-z,muldefs
    [[ -e $(archer) ]] || fail "LLVM's libarcher.so is missing, without which there are false alarms"
    filter=$(IFS=: && printf '%s' "$*")
    say "running tests of the core under ThreadSanitizer"
    OMP_NUM_THREADS=4 OMP_WAIT_POLICY=passive OMP_TOOL_LIBRARIES=$(archer) \
        TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1" \
        quietly "$folder/tests.log" "$folder/tests/core/core_tests" --gtest_brief=1 --gtest_filter="$filter" ||
        fail "a race or a failed test is in $folder/tests.log"
    ! grep -q 'PASSED.* 0 tests' "$folder/tests.log" || fail "there is no such test: $*"
    tail -n 1 "$folder/tests.log" >&2
}
