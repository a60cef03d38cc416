// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fixed/surface_walk.h"

namespace laplacian_lines {

/// What an edge turns beyond what the surface on both sides explains.
struct CreaseJump {
    float degrees;  ///< 0 or less: all is explained
    /// Whether both sides are flat at first or curve evenly, so that they can tell. Twisted ones do
    /// not.
    bool is_clear;
};

/// Triangles that meet at less, in degrees, are parts of one flat face.
constexpr float kFlat = 0.1f;

/// A curved face is cut into facets that turn again and again: by a curvature, the angle at an edge
/// over the distance between the centres of its facets. On either side of the edge, the curvature
/// of the edges beyond tells by how much a curved face turns from the middle of its first facet to
/// the edge. Both together are explained. Faces are followed straight across the edge, narrow ones
/// along the edges of the form beside them. The angle is that of signed_angle(), less than
/// kEdgeAngle.
CreaseJump crease_jump(const TriangleGraph& graph, const TriangleSide& side, float angle);

}  // namespace laplacian_lines
