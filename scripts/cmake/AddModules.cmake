# SPDX-License-Identifier: GPL-3.0-or-later

# add_module_library(NAME [SOURCES...]): a static library of these sources, or of all in src/, with hidden symbols.
function(add_module_library name)
  set(sources ${ARGN})
  if(NOT sources)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS src/*.cpp)
  endif()
  add_library(${name} STATIC ${sources})
  if(IS_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/include")
    target_include_directories(${name} PUBLIC include PRIVATE src)
  else()
    target_include_directories(${name} PUBLIC .)
  endif()
  set_target_properties(${name} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# precompile(TARGET HEADERS...): compiles expensive headers once per target, MeshLab's once for all libraries and plugins.
# Not every build does: sources include all they need.
function(precompile target)
  get_target_property(type ${target} TYPE)
  if(LAPLACIAN_LINES_PRECOMPILE AND "${ARGN}" STREQUAL "${MESHLAB_HEADERS}" AND NOT type STREQUAL EXECUTABLE
      AND NOT target STREQUAL meshlab_host)
    target_precompile_headers(${target} REUSE_FROM meshlab_host)
  elseif(LAPLACIAN_LINES_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
