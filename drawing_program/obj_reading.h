// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "laplacian_lines/triangle_mesh.h"

/// The faces of an OBJ file as triangles. Apart from other readers: vcglib's of MeshLab 2020.09
/// leaves out the faces of the first vertex.
/// @throws std::runtime_error
laplacian_lines::TriangleMesh readObj(const std::string& file);
