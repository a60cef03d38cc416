# SPDX-License-Identifier: GPL-3.0-or-later
# Static analysis: of all C++ sources by cppcheck, of all scripts by shellcheck.

require checks/clang_build environment/messages environment/packages

# The suppressions say why.
check_statically() {
    say "static analysis"
    ensure_packages "${CHECK_PACKAGES[@]}"
    (cd "$1" && cppcheck --quiet --error-exitcode=1 --std=c++17 --language=c++ -j "$(nproc)" \
        --enable=warning,performance,portability --suppressions-list=scripts/checks/cppcheck_suppressions.txt \
        -I laplacian_lines/include -I laplacian_lines/src \
        laplacian_lines line_drawing line_renderer filter_laplacian_lines decorate_laplacian_lines meshlab_host programs/drawing_program programs/headless_host >&2) ||
        fail "cppcheck found the above: fix it, or say why not in scripts/checks/cppcheck_suppressions.txt"
    (cd "$1" && find run test bench .ci/run scripts benchmarks tests -type f -exec grep -lZE '^#!.*bash|^require ' {} + |
        xargs -0 shellcheck >&2) || fail "shellcheck found the above"
}
