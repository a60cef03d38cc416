# SPDX-License-Identifier: GPL-3.0-or-later
# The target "package": a .deb for the distribution that this is built on, and a .zip of what MeshLab's "Load Plugins"
# takes. Plugins fit one version of MeshLab only, so its number is in their names, and the .deb depends on it.

if(NOT MeshLab_FOUND OR MESHLAB_IN_PYTHON)
  return()
endif()

# for the .deb alone: "cmake --install" brings none of it
set(made "${PROJECT_BINARY_DIR}/share")
install(TARGETS laplacian_lines_drawing RUNTIME DESTINATION /usr/bin COMPONENT command EXCLUDE_FROM_ALL)
install(CODE "execute_process(COMMAND \"${PROJECT_SOURCE_DIR}/scripts/product/package_files.py\"
  \"$<TARGET_FILE:laplacian_lines_drawing>\" \"${PROJECT_SOURCE_DIR}/CHANGELOG.md\" \"${made}\" COMMAND_ERROR_IS_FATAL ANY)"
  COMPONENT command EXCLUDE_FROM_ALL)
install(DIRECTORY "${made}/" DESTINATION /usr/share COMPONENT command EXCLUDE_FROM_ALL)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION . COMPONENT loose EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR DEB ZIP)
set(CPACK_PROJECT_CONFIG_FILE "${PROJECT_SOURCE_DIR}/scripts/cmake/PackagingByGenerator.cmake")
set(CPACK_OUTPUT_FILE_PREFIX "${PROJECT_BINARY_DIR}/packages")
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_PACKAGE_NAME meshlab-laplacian-lines)
set(CPACK_PACKAGE_VENDOR "Laplacian Lines")
set(CPACK_PACKAGE_CONTACT "Laplacian Lines developers <laplacian-lines@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "line drawings of scanned surfaces, in MeshLab and on paper")
set(CPACK_PACKAGE_DESCRIPTION
  "A decoration that draws the Laplacian lines, contours, ridges and borders of a\nmesh as it is turned, and filters that compute them for scripts and as\npolylines. The command laplacian-lines draws meshes at scale on paper, as PDF,\nSVG, DXF or PNG.")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}+meshlab${MeshLab_VERSION}")
set(CPACK_PACKAGE_FILE_NAME "meshlab-laplacian-lines-${CPACK_PACKAGE_VERSION}-${CMAKE_SYSTEM_PROCESSOR}")
if(LAPLACIAN_LINES_PORTABLE)
  string(APPEND CPACK_PACKAGE_FILE_NAME "-portable")
endif()

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
# All of Debian's packages of this upstream version: "2025.07~dfsg-4" comes before "2025.07", and any "2025.07+..."
# before "2025.07.".
set(CPACK_DEBIAN_PACKAGE_DEPENDS "meshlab (>= ${MeshLab_VERSION}~), meshlab (<< ${MeshLab_VERSION}.)")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${MESHLAB_LIBRARY_DIR}")

include(CPack)
