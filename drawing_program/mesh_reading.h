// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "laplacian_lines/triangle_mesh.h"

/// Of the files that readMesh() reads: "ply" and so on.
QStringList meshEndings();

/// Reads a mesh as MeshLab does: PLY, OBJ, STL, OFF. Polygons become triangles.
/// @throws laplacian_lines::Error(InvalidMesh) with a sentence that names the file.
laplacian_lines::TriangleMesh readMesh(const QString& file);
