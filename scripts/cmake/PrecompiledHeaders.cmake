# SPDX-License-Identifier: GPL-3.0-or-later
# precompile(TARGET HEADERS...): compiles the headers that most of compiling goes into once for a target. Sources include
# what they need all the same, since not every build does this.
function(precompile target)
  if(LAPLACIAN_LINES_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
