// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

/// Reads a sound PLY, STL, OBJ or OFF file, also gzipped (.gz; needs the program gzip).
/// @throws std::runtime_error
laplacian_lines::TriangleMesh read_mesh(const std::string& path);

/// Without folder and extensions.
std::string mesh_name(const std::string& path);

}  // namespace test_meshes
