// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>

#include "laplacian_lines/field.h"
#include "laplacian_lines/precompute_options.h"
#include "laplacian_lines/triangle_mesh.h"
#include "meshlab_host/meshlab_api.h"

/// Lines of the log about a finished computation. "None were left out" is not said.
QStringList computeReport(const laplacian_lines::Field& field,
                          const laplacian_lines::PrecomputeOptions& options, double seconds);

/// Up to this many faces are looked at before a dialog opens.
constexpr int most_faces_looked_at = 1000000;

/// A stand-in for a large mesh, for dialogs: some triangles without common vertices, evenly spread
/// over the mesh's order, and the vertices farthest along axes and diagonals, as triangles without
/// area. Of the mesh's size, exactly along the axes, and its mean edge to a few thousandths. None
/// for small meshes, and if vertices reach beyond the faces, as those do not count. In mesh
/// coordinates. Not while the mesh changes.
std::optional<laplacian_lines::TriangleMesh> coarseCopy(const CMeshO& mesh);
