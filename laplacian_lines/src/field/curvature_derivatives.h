// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/field.h"
#include "mesh/prepared_mesh.h"
#include "mesh/spatial_tree.h"
#include "mesh/vertex_ranges.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Fills Field::smooth_curvatures and curvature_derivatives from the rest of the field alone,
/// whether it has just been computed or comes from elsewhere: the same bits.
///
/// C is the slope of the linear function of the place in the tangent plane that best fits the S of
/// the vertices within kDerivativeReach √h, each by its mass, its nearness and how it faces. A fit
/// takes away what the triangles' shapes and noise do; docs/accuracy.md compares it with other
/// ways. Where there are too few vertices for one: ring_derivatives().
///
/// S̄ is the value, at the vertex, of such a function of the vertices within kSmoothReach √h, or S
/// where there are too few. Borders do not bias it.
void fill_curvature_derivatives(const PreparedMesh& mesh, const SpatialTree& tree,
                                const VertexRanges& ranges, const StageProgress& stage,
                                Field& field);

/// The spread of the weights is that of a kernel of 0.85 √h.
constexpr double kDerivativeReach = 3.4;
/// In mean edges: beyond it nothing gets better, but slower.
constexpr double kMostDerivativeReach = 16;
/// That of a kernel of 0.35 √h: lines keep what can be seen, and lose what noise of a fifth of the
/// edges adds. S̄ ends at as much less than C on the finest meshes.
constexpr double kSmoothReach = 1.4;

}  // namespace laplacian_lines
