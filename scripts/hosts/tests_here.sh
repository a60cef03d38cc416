# SPDX-License-Identifier: GPL-3.0-or-later
# The tests with the MeshLab that is installed here.

require environment/build environment/durations environment/messages environment/packages hosts/ctest

# run_tests CHECKOUT LABEL REGEX...: builds and runs the tests with the MeshLab installed here; with a LABEL only those
# that have it, without any also the core's
run_tests() {
    local checkout=$1 label=$2 options=() target=() began=$SECONDS
    shift 2
    ensure_toolchain "${DISPLAY_PACKAGES[@]}" "${TEST_PACKAGES[@]}"
    [[ -z $label ]] || { options+=(--label-regex "$label") target=(meshlab_tests); }
    add_regex options "$@"
    say "building the plugins and the tests for MeshLab $(meshlab_version)"
    build_targets "$checkout" "${target[@]}" -- -DLAPLACIAN_LINES_BUILD_TESTS=ON -DLAPLACIAN_LINES_WERROR=ON
    say "built in $(duration $((SECONDS - began))); running the tests"
    run_ctest "$(build_folder "$checkout")" "${options[@]}"
}
