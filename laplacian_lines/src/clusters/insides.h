// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "clusters/extractor_data.h"
#include "clusters/planes.h"

namespace laplacian_lines {

/// Whether triangles face outwards, as far as the volume within them tells.
inline bool faces_outwards(const std::vector<PlacedCluster>& clusters) {
    double volume = 0;  // six times
    for (const PlacedCluster& placed : clusters)
        for (unsigned t = 0; t < placed.cluster->triangle_count; ++t) {
            const auto corner = [&, triangle = placed.triangle(t)](unsigned k) {
                return position_of(placed.records[triangle.corners[k]]).cast<double>().eval();
            };
            volume += corner(0).dot(corner(1).cross(corner(2)));
        }
    return volume > 0;
}

inline bool has_borders(const std::vector<PlacedCluster>& clusters) {
    for (const PlacedCluster& placed : clusters)
        for (unsigned t = 0; t < placed.cluster->triangle_count; ++t)
            for (const unsigned neighbour : placed.triangle(t).neighbours)
                if (neighbour == kNoNeighbour) return true;
    return false;
}

/// Whether what faces away is hidden.
inline bool is_body(const std::vector<PlacedCluster>& clusters) {
    return !has_borders(clusters) && faces_outwards(clusters);
}

/// Whether the eye may be inside, from where back faces are what is seen.
inline bool may_be_within(const LocalEye& eye) {
    return eye.eye.norm() < 0.5f * eye.w;  // a ball around the mesh
}

}  // namespace laplacian_lines
