# SPDX-License-Identifier: GPL-3.0-or-later
# Installed for find_package(LaplacianLines): adds LaplacianLines::laplacian_lines. The library is a static one, so a
# program needs what the core itself needs.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 NO_MODULE)
find_dependency(Threads)
include("${CMAKE_CURRENT_LIST_DIR}/LaplacianLinesTargets.cmake")
