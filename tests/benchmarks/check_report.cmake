# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D REPORT=FILE [-D IN_MESHLAB=ON] -P check_report.cmake: what ./bench --json has written is JSON and holds the
# figures of one mesh, or those in MeshLab.
cmake_minimum_required(VERSION 3.19)

file(READ "${REPORT}" report)

function(expect_positive)
  string(JSON value ERROR_VARIABLE error GET "${report}" ${ARGN})
  if(error OR NOT value GREATER 0)
    message(FATAL_ERROR "${ARGN}: '${value}' instead of a positive number ${error}")
  endif()
endfunction()

expect_positive(core machine processors)
if(IN_MESHLAB)
  expect_positive(in_meshlab filter_s)
  return()
endif()

foreach(key commit "core;compiler" "core;machine;processor")
  string(JSON value GET "${report}" ${key})
endforeach()
string(JSON meshes LENGTH "${report}" core meshes)
if(NOT meshes EQUAL 1)
  message(FATAL_ERROR "${meshes} meshes instead of 1")
endif()

# expect_figures SECTION KEY...
function(expect_figures section)
  foreach(key ${ARGN})
    expect_positive(core meshes 0 ${section} ${key})
  endforeach()
endfunction()

foreach(section extraction_ms extraction_median_ms)
  expect_figures(${section} lines default_style plain_contours plain_laplacian
    plain_laplacian_traced read_plain_mesh read_extractor)
endforeach()
expect_figures(building_s field laplacian plain_sum extractor)
expect_figures(memory extractor field)
expect_figures(ratios lines_to_contours lines_to_traced lines_to_reading)
expect_figures(counts rounds lines segments)
