// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "clusters/cluster_partition.h"
#include "laplacian_lines/field.h"

namespace laplacian_lines {

/// Planes N·(e − w p) = 0 in the homogeneous eye (e, w): N and N·p, one array for each number, so
/// that a pass over all is vectorized.
struct Planes {
    std::vector<float> x, y, z, offset;

    std::size_t size() const { return x.size(); }
    void add(const Eigen::Vector3d& normal, const Eigen::Vector3d& p) {
        x.push_back(float(normal.x()));
        y.push_back(float(normal.y()));
        z.push_back(float(normal.z()));
        offset.push_back(float(normal.dot(p)));
    }

    /// values[i] = N·(e − w p) of plane i, positive if its front is seen.
    void evaluate(const Eigen::Vector3f& eye, float w, std::vector<float>& values) const {
        const float ex = eye.x(), ey = eye.y(), ez = eye.z();
        values.resize(size());
        for (std::size_t i = 0; i < size(); ++i)
            values[i] = x[i] * ex + y[i] * ey + z[i] * ez - w * offset[i];
    }
};

/// The edges that contours can follow: those of coarse triangles, see coarseness.h. Local
/// coordinates; vertices and triangles have numbers of their own. Empty on a fine mesh.
struct CoarseHorizon {
    /// Between two coarse triangles.
    struct Edge {
        std::uint32_t vertices[2];
        std::uint32_t triangles[2];
        bool is_reversed;  ///< the two triangles are of opposite orientation
        bool is_hollow;    ///< of a body, which hides a contour there: what faces away is before it
    };
    /// Between a coarse triangle and one that is not. There a contour can come from the other
    /// side, at the edge of this number in ExtractorData::border_edges.
    struct OuterEdge {
        std::uint32_t number;  ///< ascending
        std::uint32_t vertices[2];
        std::uint32_t triangle;
    };
    std::vector<Edge> edges;
    std::vector<OuterEdge> outer_edges;
    std::vector<Eigen::Vector3f> positions;  ///< by vertex
    Planes facing;                           ///< by vertex: n·(e − w p)
    Planes planes;                           ///< by triangle; N is its unit normal

    bool empty() const { return edges.empty() && outer_edges.empty(); }
    std::size_t memory() const;  ///< bytes, but for the object itself
};

/// `coarse`: by triangle, see coarseness.h. `is_body`: what faces away is hidden.
CoarseHorizon find_coarse_horizon(const PreparedMesh& mesh, const Field& field,
                                  const CornerTable& sides, const std::vector<std::uint8_t>& coarse,
                                  const Partition& partition, const ClusterLinks& links,
                                  bool is_body);

}  // namespace laplacian_lines
