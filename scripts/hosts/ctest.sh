# SPDX-License-Identifier: GPL-3.0-or-later
# How tests run: several at once, those of MeshLab's windows waiting half of their time.

# run_ctest BUILD OPTIONS...
run_ctest() {
    ctest --test-dir "$1" --output-on-failure --parallel "$((2 * $(nproc)))" "${@:2}"
}

# add_regex OPTIONS REGEX...: has ctest's OPTIONS, the name of an array, run only tests that match one REGEX; without any,
# all but those that ./test --reach is for
add_regex() {
    local -n ctest_options=$1
    shift
    if (($#)); then
        ctest_options+=(--tests-regex "$(IFS='|' && printf '%s' "$*")")
    else
        ctest_options+=(--label-exclude '^reach$')
    fi
}
