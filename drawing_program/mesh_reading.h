// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "laplacian_lines/triangle_mesh.h"

/// The meshes that are named, and those in the folders that are named, by their names.
/// @throws laplacian_lines::Error(InvalidOption) if there is none in a folder.
QStringList meshesOf(const QStringList& named);

/// Reads a mesh as MeshLab does: PLY, OBJ, STL, OFF. Polygons become triangles.
/// @throws laplacian_lines::Error(InvalidMesh) with a sentence that names the file.
laplacian_lines::TriangleMesh readMesh(const QString& file);
