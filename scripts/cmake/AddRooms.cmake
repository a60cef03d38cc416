# SPDX-License-Identifier: GPL-3.0-or-later

# add_room(FOLDER): if it is in this checkout.
function(add_room folder)
  if(EXISTS "${PROJECT_SOURCE_DIR}/${folder}/CMakeLists.txt")
    add_subdirectory("${PROJECT_SOURCE_DIR}/${folder}" "${PROJECT_BINARY_DIR}/${folder}")
  endif()
endfunction()

# add_room_library(NAME [SOURCES...]): a static library of all sources in src/, or of those named, for the plugins.
function(add_room_library name)
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

# precompile(TARGET HEADERS...): compiles the headers that most of compiling goes into once for a target. Sources include
# what they need all the same, since not every build does this.
function(precompile target)
  if(LAPLACIAN_LINES_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
