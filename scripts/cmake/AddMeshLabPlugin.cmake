# SPDX-License-Identifier: GPL-3.0-or-later

add_custom_target(picture_plugins COMMENT "What a picture of MeshLab's view takes: all but the filters")
add_custom_target(meshlab_plugins COMMENT "All that MeshLab is to load")
add_dependencies(meshlab_plugins picture_plugins)

# add_meshlab_plugin(NAME SOURCES...): built into <build>/plugins, installed to MeshLab's plugin folder.
function(add_meshlab_plugin name)
  add_loadable_plugin(${name} ${ARGN})
  set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/plugins")
  install(TARGETS ${name} LIBRARY DESTINATION "${LAPLACIAN_LINES_PLUGIN_DESTINATION}" COMPONENT plugins)
  install(TARGETS ${name} LIBRARY DESTINATION . COMPONENT loose EXCLUDE_FROM_ALL) # see Packaging.cmake
endfunction()

# add_loadable_plugin(NAME SOURCES...): neither placed among the plugins nor installed.
function(add_loadable_plugin name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE MeshLab::common)
  target_link_options(${name} PRIVATE -Wl,--as-needed)
  if(NOT LAPLACIAN_LINES_SANITIZE) # the program that loads it brings the sanitizers' library
    target_link_options(${name} PRIVATE -Wl,--no-undefined
      "-Wl,--version-script=${PROJECT_SOURCE_DIR}/scripts/cmake/plugin_exports.map")
  endif()
  set_target_properties(${name} PROPERTIES
    AUTOMOC ON
    DEFINE_SYMBOL "" # precompiled headers are of libraries without one
    SKIP_BUILD_RPATH ON # MeshLab has loaded its library before any plugin; another of that name must not come in
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
  precompile(${name} "${MESHLAB_HEADERS}")
  add_dependencies(meshlab_plugins ${name})
  if(NOT name MATCHES filter)
    add_dependencies(picture_plugins ${name})
  endif()
endfunction()
