// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>

#include "laplacian_lines/field.h"
#include "laplacian_lines/precompute_options.h"
#include "laplacian_lines/triangle_mesh.h"
#include "meshlab_host/meshlab_api.h"

/// What the user wants to know about a finished computation, one line of the log each. Parts that
/// say "none were left out" are not there.
QStringList computeReport(const laplacian_lines::Field& field,
                          const laplacian_lines::PrecomputeOptions& options, double seconds);

/// Meshes up to this many faces are looked at whole before a dialog opens.
constexpr int most_faces_looked_at = 1000000;

/// What a dialog has to know of a large mesh without looking at all of it: some of its triangles,
/// spread evenly over the mesh's own order, none with a vertex of another; and of its vertices
/// those that reach farthest along its axes and diagonals, as triangles without an area. As large
/// as the mesh, exactly so along the axes, and with a mean edge within a few thousandths of the
/// mesh's. None of a mesh that is not large, and of one whose vertices reach beyond its faces,
/// since those do not count. In mesh coordinates. Not to be called while the mesh changes.
std::optional<laplacian_lines::TriangleMesh> coarseCopy(const CMeshO& mesh);
