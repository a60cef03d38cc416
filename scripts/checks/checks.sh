# SPDX-License-Identifier: GPL-3.0-or-later
# What tests alone do not see, one check after the other. Each check_... prints on stdout what is worth telling about its
# success.

require checks/clang_build checks/fuzzing checks/large_meshes checks/sanitized_core checks/static_analysis

# run_checks CHECKOUT CONCLUDE: calls CONCLUDE NAME CODE REMARK after each
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
