# SPDX-License-Identifier: GPL-3.0-or-later
# The tests of the filter in PyMeshLab.

require environment/durations environment/messages hosts/ctest product/pymeshlab

# test_pymeshlab CHECKOUT REGEX...: its tests. Sets OBSTACLE when it cannot be set up.
test_pymeshlab() {
    local checkout=$1 options=(--label-regex pymeshlab) began=$SECONDS
    shift
    ensure_pymeshlab && ensure_pymeshlab_headers || return 1
    add_regex options "$@"
    (build_for_pymeshlab "$checkout" pymeshlab_tests -DLAPLACIAN_LINES_BUILD_TESTS=ON -DLAPLACIAN_LINES_WERROR=ON) || return 1
    say "built in $(duration $((SECONDS - began))); running the tests in PyMeshLab"
    run_ctest "$checkout/build/pymeshlab" "${options[@]}"
}
