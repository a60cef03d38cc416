// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_set.h"
#include "meshlab_host/drawn_style.h"
#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// Fills an empty mesh with lines: a vertex for each point, in their order, and an edge for each
/// segment; a closed line's last point is its first vertex. Per vertex, as Scalarm:
///     ll_line                          number of the line, from 0
///     ll_kind                          laplacian_lines::LineKind of the line, as a number
///     ll_strength, ll_slope            of the line, see Polyline
///     ll_weight, ll_gradient, ll_opacity   of the point, see LinePoint
/// and as quality weight times opacity: how much ink the point takes.
void toEdgeMesh(const laplacian_lines::LineSet& lines, CMeshO& mesh);

/// Gives each vertex of an edge mesh of these lines the color of its line's kind.
void setColors(const laplacian_lines::LineSet& lines, const KindColors& colors, CMeshO& mesh);

/// Gives each vertex of an edge mesh the field's normal at the surface's nearest vertex. MeshLab
/// lights points by their normals; without any, their color depends on the OpenGL driver.
void setNormals(const laplacian_lines::TriangleMesh& surface, const laplacian_lines::Field& field,
                CMeshO& mesh);

}  // namespace meshlab_host
