// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "laplacian_lines/triangle_mesh.h"

/// Reads a mesh as MeshLab does: PLY, OBJ, STL, OFF. Polygons become triangles.
/// @throws laplacian_lines::Error(InvalidMesh) with a sentence that names the file.
laplacian_lines::TriangleMesh readMesh(const QString& file);
