# SPDX-License-Identifier: GPL-3.0-or-later
# The core's tests of meshes of millions of triangles.

require environment/build environment/messages environment/packages

# The tests of meshes that take seconds and up to 2.2 GB.
check_large_meshes() {
    local build log
    build=$(build_folder "$1") log=$(build_folder "$1")/large_meshes.log
    ensure_packages "${CORE_PACKAGES[@]}" "${TEST_PACKAGES[@]}"
    build_targets "$1" core_tests -- -DLAPLACIAN_LINES_BUILD_TESTS=ON -DLAPLACIAN_LINES_WERROR=ON
    say "computing large meshes"
    LAPLACIAN_LINES_LARGE=1 quietly "$log" "$build/tests/core/core_tests" --gtest_filter='Meshes/Large.*' ||
        fail "a large mesh took too much time or memory, or was not refused; the log is $log"
    awk '/PASSED/ { print $4 " meshes" }' "$log"
}
