// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_set.h"
#include "laplacian_lines/triangle_mesh.h"
#include "meshlab_host/drawn_style.h"
#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// Fills an empty mesh with lines: a vertex per point, in order, and an edge per segment; a closed
/// line's last point is its first vertex. Per vertex, as Scalarm:
///     ll_line                          number of the line, from 0
///     ll_kind                          laplacian_lines::LineKind of the line, as a number
///     ll_strength, ll_slope            of the line, see Polyline; no slope is below 0
///     ll_weight, ll_gradient, ll_opacity   of the point, see LinePoint
/// and as quality weight times opacity, the point's ink.
void to_edge_mesh(const laplacian_lines::LineSet& lines, CMeshO& mesh);

/// Colors vertices by the kind of their line.
void set_colors(const laplacian_lines::LineSet& lines, const KindColors& colors, CMeshO& mesh);

/// The surface's normals at its nearest vertices. MeshLab lights points by them; without normals
/// their color depends on the OpenGL driver.
void set_normals(const laplacian_lines::TriangleMesh& surface, CMeshO& mesh);

}  // namespace meshlab_host
