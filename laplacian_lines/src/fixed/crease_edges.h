// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "clusters/extractor_data.h"
#include "system/three_floats.h"

namespace laplacian_lines {

/// An edge of the mesh that may be drawn as part of a crease. Local coordinates.
struct CreaseEdge {
    std::uint32_t vertices[2];
    Eigen::Vector3f positions[2];
    Eigen::Vector3f normals[2];  ///< of the triangles; as one sees them from the same side
    float angle;                 ///< between the normals, degrees
    /// The largest LineStyle::crease_angle with which it is drawn: its angle, or 40 if that is less
    /// and the faces around do not explain it.
    float shown_up_to;

    float length() const { return length_of(positions[1] - positions[0]); }
};

/// All edges that a style with this crease angle, in degrees, or a larger one may draw. The number
/// of threads does not matter.
std::vector<CreaseEdge> find_crease_edges(const ExtractorData& data, float least_angle);

}  // namespace laplacian_lines
