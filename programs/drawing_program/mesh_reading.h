// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "laplacian_lines/triangle_mesh.h"

/// The meshes that are named, and those in the folders that are named, by their names.
/// @throws laplacian_lines::Error(InvalidOption) if there is none in a folder.
QStringList meshesOf(const QStringList& named);

struct ReadMesh {
    laplacian_lines::TriangleMesh mesh;
    QString defect;  ///< of a damaged file: why the mesh is not whole
    /// Of the file's bytes, in hexadecimal; computed while the mesh is drawn.
    std::shared_future<std::string> sha256;
};

/// Reads a mesh of a PLY, OBJ, STL or OFF file. Polygons become triangles. A file that is not as
/// its format has it is refused, or what comes before that is drawn.
/// @throws laplacian_lines::Error(InvalidMesh) with a sentence that names the file.
ReadMesh readMesh(const QString& name, bool draws_damaged);
