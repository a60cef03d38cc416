// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <future>

#include "laplacian_lines/triangle_mesh.h"

/// The named meshes and those in named folders. @throws laplacian_lines::Error(InvalidOption) if a
/// folder has none
QStringList meshesOf(const QStringList& named);

/// From the file's beginning and size; 0 if it cannot be read.
double expectedTriangles(const QString& name);

struct ReadMesh {
    laplacian_lines::TriangleMesh mesh;
    QString defect;  ///< of a damaged file: why the mesh is not whole
    QString remark;  ///< what of a sound file was skipped
    /// Of the file, in hexadecimal; computed while the mesh is drawn.
    std::shared_future<std::string> sha256;
};

/// Reads a PLY, OBJ, STL or OFF file, triangulated. A malformed file is refused, or drawn as far as
/// it goes. @throws laplacian_lines::Error(InvalidMesh) with a sentence that names the file
ReadMesh readMesh(const QString& name, bool draws_damaged);
