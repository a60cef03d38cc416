# SPDX-License-Identifier: GPL-3.0-or-later
# Read by CPack for each of its generators: the .deb holds plugins and command in their places, the .zip the plugins loose.
if(CPACK_GENERATOR STREQUAL "DEB")
  set(CPACK_SET_DESTDIR ON) # MeshLab's plugin folder is an absolute one
  # with DESTDIR, CPack makes the folder of this prefix, and the package would own it
  set(CPACK_INSTALL_PREFIX /usr)
  set(CPACK_COMPONENTS_ALL plugins command)
else()
  set(CPACK_COMPONENTS_ALL loose)
endif()
