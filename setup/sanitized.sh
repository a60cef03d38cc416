# SPDX-License-Identifier: GPL-3.0-or-later
# The GUI's tests with plugins that are compiled with sanitizers, in an ordinary MeshLab.

SANITIZED_TESTS=(gui_filter gui_edits gui_documents) # without any named

# A leak of MeshLab, Qt or OpenGL is not ours: only those count that a function of our plugins has allocated.
leaks_of_plugins() {
    awk 'BEGIN { RS = "" } /leak of/ && /lib(filter|decorate)_laplacian_lines\.so/'
}

# test_sanitized CHECKOUT REGEX...
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
        ASAN_OPTIONS="log_path=$reports/of:detect_leaks=1:stack_trace_format='    #%n %f %S %M'" \
        UBSAN_OPTIONS="log_path=$reports/of:print_stacktrace=1" LSAN_OPTIONS=exitcode=0:use_tls=0 \
        ctest --test-dir "$folder" --label-regex meshlab --tests-regex "$regex" --output-on-failure || code=$?
    find "$reports" -type f -exec grep -qE 'ERROR: AddressSanitizer|runtime error' {} \; -exec head -n 40 {} \; >&2
    find "$reports" -type f -exec cat {} + | leaks_of_plugins >"$folder/leaks.txt"
    if [[ -s $folder/leaks.txt ]]; then
        head -n 40 "$folder/leaks.txt" >&2
        fail "memory was lost; all of it is in $folder/leaks.txt"
    fi
    ((code == 0)) || fail "a test failed; the sanitizers' reports are in $reports"
}
