# SPDX-License-Identifier: GPL-3.0-or-later
# "cmake --install" installs the core as the package LaplacianLines, for programs that have nothing to do with MeshLab.
# As a component of its own: packages of the plugins hold none of it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/LaplacianLines")
install(TARGETS laplacian_lines EXPORT LaplacianLinesTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT core
  INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/laplacian_lines/include/"
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT core FILES_MATCHING PATTERN "*.h")
install(EXPORT LaplacianLinesTargets NAMESPACE LaplacianLines::
  DESTINATION "${package_folder}" COMPONENT core)

# while the version begins with 0, a new minor one may change anything
write_basic_package_version_file("${PROJECT_BINARY_DIR}/LaplacianLinesConfigVersion.cmake"
  VERSION "${PROJECT_VERSION}" COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_SOURCE_DIR}/scripts/cmake/LaplacianLinesConfig.cmake"
  "${PROJECT_BINARY_DIR}/LaplacianLinesConfigVersion.cmake"
  DESTINATION "${package_folder}" COMPONENT core)
