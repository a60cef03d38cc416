# SPDX-License-Identifier: GPL-3.0-or-later
# Finds the installed MeshLab, or that of the library MESHLAB_COMMON_LIBRARY, such as PyMeshLab's, and the headers of the
# same version: MESHLAB_SOURCE_DIR is a folder with its unpacked source, such as ./run has fetched into the cache folder.
#
# Sets  MeshLab_FOUND, MeshLab_VERSION ("2020.09"), MESHLAB_API (2020, 2022 or 2025: which plugin API the headers
#       speak), MESHLAB_SCALAR (float or double), MESHLAB_LIBRARY_DIR, MESHLAB_PLUGIN_DIR (where MeshLab looks for
#       plugins), MESHLAB_IN_PYTHON (true for PyMeshLab's)
# Adds  MeshLab::common

find_library(MESHLAB_COMMON_LIBRARY meshlab-common PATH_SUFFIXES meshlab
             DOC "MeshLab's shared library")

# only the installed version's headers will do, whatever else the cache holds
execute_process(COMMAND dpkg-query -W "-f=\${Version}" meshlab
                OUTPUT_VARIABLE _meshlab_package_version ERROR_QUIET)
set(_meshlab_headers "$ENV{LAPLACIAN_LINES_CACHE}" "$ENV{XDG_CACHE_HOME}/laplacian-lines" "$ENV{HOME}/.cache/laplacian-lines")
list(TRANSFORM _meshlab_headers APPEND "/headers/${_meshlab_package_version}")
find_path(MESHLAB_SOURCE_DIR src/common/mlexception.h PATHS ${_meshlab_headers} NO_DEFAULT_PATH
          DOC "Folder with the unpacked source of the installed MeshLab")

# Which API: by what the headers hold, so that a wrong folder cannot claim another version.
set(MESHLAB_API "")
if(EXISTS "${MESHLAB_SOURCE_DIR}/src/common/interfaces.h")
  set(MESHLAB_API 2020)
elseif(EXISTS "${MESHLAB_SOURCE_DIR}/src/common/parameters/rich_parameter")
  set(MESHLAB_API 2025)
elseif(EXISTS "${MESHLAB_SOURCE_DIR}/src/common/parameters/rich_parameter.h")
  set(MESHLAB_API 2022)
endif()

set(MeshLab_VERSION "")
if(EXISTS "${MESHLAB_SOURCE_DIR}/ML_VERSION")
  file(STRINGS "${MESHLAB_SOURCE_DIR}/ML_VERSION" MeshLab_VERSION LIMIT_COUNT 1)
  string(STRIP "${MeshLab_VERSION}" MeshLab_VERSION)
endif()

# vcglib lies beside src/ in 2020.09 and inside it later. Not cached: it has to follow MESHLAB_SOURCE_DIR.
set(MESHLAB_VCGLIB_DIR "")
foreach(_meshlab_folder vcglib src/vcglib)
  if(EXISTS "${MESHLAB_SOURCE_DIR}/${_meshlab_folder}/vcg/complex/complex.h")
    set(MESHLAB_VCGLIB_DIR "${MESHLAB_SOURCE_DIR}/${_meshlab_folder}")
  endif()
endforeach()

# What MeshLab's coordinates are, as the library says it: a constructor's mangled name ends in the scalar's letter.
set(MESHLAB_SCALAR float)
set(MESHLAB_IN_PYTHON FALSE)
if(MESHLAB_COMMON_LIBRARY)
  get_filename_component(MESHLAB_LIBRARY_DIR "${MESHLAB_COMMON_LIBRARY}" DIRECTORY)
  file(STRINGS "${MESHLAB_COMMON_LIBRARY}" _meshlab_double REGEX "_ZN9RichFloatC[12]ERK7QStringd" LIMIT_COUNT 1)
  if(_meshlab_double)
    set(MESHLAB_SCALAR double)
  endif()
  file(GLOB _meshlab_python_module "${MESHLAB_LIBRARY_DIR}/../pmeshlab.*.so")
  if(_meshlab_python_module)
    set(MESHLAB_IN_PYTHON TRUE)
  endif()
endif()

find_package(Qt5 QUIET COMPONENTS Core Gui Widgets OpenGL Xml)
set(OpenGL_GL_PREFERENCE LEGACY) # libGL.so.1, as MeshLab's own library: a machine may have no other
find_package(OpenGL QUIET)
find_path(GLEW_INCLUDE_DIR GL/glew.h DOC "GLEW's headers, which MeshLab's include")
find_package(Eigen3 QUIET NO_MODULE)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MeshLab
  REQUIRED_VARS MESHLAB_COMMON_LIBRARY MESHLAB_SOURCE_DIR MESHLAB_API MESHLAB_VCGLIB_DIR Qt5_FOUND OPENGL_FOUND
                GLEW_INCLUDE_DIR Eigen3_FOUND
  VERSION_VAR MeshLab_VERSION)
mark_as_advanced(MESHLAB_COMMON_LIBRARY GLEW_INCLUDE_DIR)

if(MeshLab_FOUND AND NOT TARGET MeshLab::common)
  set(MESHLAB_PLUGIN_DIR "${MESHLAB_LIBRARY_DIR}/plugins")

  add_library(MeshLab::common SHARED IMPORTED)
  # No GLEW: its name differs from system to system, and nothing of ours calls it.
  # Imported targets' include folders count as system folders: vcglib's warnings are not ours to mend.
  set_target_properties(MeshLab::common PROPERTIES
    IMPORTED_LOCATION "${MESHLAB_COMMON_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${MESHLAB_SOURCE_DIR}/src;${MESHLAB_VCGLIB_DIR};${GLEW_INCLUDE_DIR}"
    INTERFACE_COMPILE_DEFINITIONS "MESHLAB_SCALAR=${MESHLAB_SCALAR};MESHLAB_API=${MESHLAB_API};MESHLAB_VERSION=${MeshLab_VERSION}"
    INTERFACE_LINK_LIBRARIES
      "Qt5::Core;Qt5::Gui;Qt5::Widgets;Qt5::OpenGL;Qt5::Xml;OpenGL::GL;OpenGL::GLU;Eigen3::Eigen")
  if(LAPLACIAN_LINES_PORTABLE) # this system has not what that library needs
    set_target_properties(MeshLab::common PROPERTIES
      INTERFACE_LINK_OPTIONS "-Wl,--unresolved-symbols=ignore-in-shared-libs")
  endif()
endif()
