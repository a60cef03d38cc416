// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "mesh/corner_table.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// The edges that contours follow on a coarse mesh, see coarseness.h: those at which a triangle
/// that faces the eye and one that does not meet. Local coordinates.
struct EdgeHorizon {
    struct Edge {
        std::uint32_t vertices[2], triangles[2];
        bool is_reversed;  ///< the two triangles are of opposite orientation
        bool is_hollow;    ///< concave, of a body, which hides contours there
    };
    std::vector<Edge> edges;
    std::vector<Eigen::Vector3f> positions;  ///< by vertex
    /// By triangle, its plane N·(e − w p) = 0 in the homogeneous eye (e, w), N of unit length: N
    /// and N·p, one array for each number, so that a pass over all is vectorized.
    std::vector<float> planes[4];

    /// facing[i] = N·(e − w p) of triangle i, positive if its front is seen.
    void evaluate(const Eigen::Vector3f& eye, float w, std::vector<float>& facing) const;
    std::size_t memory() const;  ///< bytes, but for the object itself
};

/// `is_body`: what faces away is hidden.
EdgeHorizon find_edge_horizon(const PreparedMesh& mesh, const CornerTable& sides, bool is_body);

}  // namespace laplacian_lines
