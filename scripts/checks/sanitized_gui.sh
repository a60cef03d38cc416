# SPDX-License-Identifier: GPL-3.0-or-later
# The GUI's tests with plugins that are compiled with sanitizers, in an ordinary MeshLab.

require checks/clang_build environment/messages environment/packages

SANITIZED_TESTS=(gui_filter gui_edits gui_views gui_memory gui_random_actions) # without any named
SANITIZED_SECONDS=900 # for one test: MeshLab is slower, and looking for leaks takes its time

# A leak of MeshLab, Qt or OpenGL is not ours: only those count that a function of our plugins has allocated.
leaks_of_plugins() {
    awk 'BEGIN { RS = "" } /leak of/ && /lib(filter|decorate)_laplacian_lines\.so/'
}

# test_sanitized CHECKOUT REGEX...
# malloc_context_size: what allocates, and who calls it. MeshLab and Qt are compiled without frame pointers, so whatever
# seems to be farther up is not; the sanitizer would search all libraries for each of thousands of such addresses.
test_sanitized() {
    local checkout=$1 folder reports regex code=0
    shift
    folder=$(checks_folder "$checkout") reports=$(checks_folder "$checkout")/reports
    (($#)) || set -- "${SANITIZED_TESTS[@]}"
    ensure_packages "${DISPLAY_PACKAGES[@]}"
    build_checks "$checkout" meshlab_tests
    rm -rf "$reports"
    mkdir -p "$reports"
    regex=$(IFS='|' && printf '%s' "$*")
    say "running the tests under sanitizers"
    SANITIZER_LIBRARY=$(clang -print-file-name="libclang_rt.asan-$(uname -m).so") LLVM_PROFILE_FILE=/dev/null \
        DRIVE_SECONDS=$SANITIZED_SECONDS RANDOM_SEEDS=${RANDOM_SEEDS:-3} \
        ASAN_OPTIONS="log_path=$reports/of:detect_leaks=1:malloc_context_size=2:stack_trace_format='    #%n %f %S %M'" \
        UBSAN_OPTIONS="log_path=$reports/of:print_stacktrace=1" \
        LSAN_OPTIONS="exitcode=0:use_tls=0:print_suppressions=0:suppressions=$checkout/scripts/checks/leak_suppressions.txt" \
        ctest --test-dir "$folder" --label-regex meshlab --tests-regex "$regex" --output-on-failure || code=$?
    find "$reports" -type f -exec grep -qE 'ERROR: AddressSanitizer|runtime error' {} \; -exec head -n 40 {} \; >&2
    find "$reports" -type f -exec cat {} + | leaks_of_plugins >"$folder/leaks.txt"
    if [[ -s $folder/leaks.txt ]]; then
        head -n 40 "$folder/leaks.txt" >&2
        fail "memory leaked; all leaks are in $folder/leaks.txt"
    fi
    ((code == 0)) || fail "a test failed; the sanitizers' reports are in $reports"
    [[ -n $(find "$reports" -type f) ]] || fail "the sanitizers did not look for leaks: there is no report"
}
