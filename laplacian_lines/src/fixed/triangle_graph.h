// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "clusters/extractor_data.h"
#include "system/three_floats.h"

namespace laplacian_lines {

/// Side k of a triangle; no triangle: there is no such side.
struct TriangleSide {
    std::uint32_t triangle;
    unsigned k;
};

/// The triangles of all clusters with their neighbours in any cluster, for single passes over the
/// mesh. Local coordinates.
struct TriangleGraph {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    /// Side k is from corner k to the next.
    struct Node {
        Eigen::Vector3f normal;  ///< unit; zero where floats leave no area
        Eigen::Vector3f centre;
        float area;
        std::uint32_t corners[3];     ///< in `records`
        std::uint32_t neighbours[3];  ///< by side; kNone where the surface ends
        std::uint32_t reversed;       ///< bit k: neighbour k has the opposite orientation

        /// Turns the neighbour's normal to this one's side.
        float sign_across(unsigned k) const { return reversed >> k & 1 ? -1.f : 1.f; }
    };
    const VertexRecord* records = nullptr;  ///< those of the extractor's data
    std::unique_ptr<Node[]> triangles;      ///< cluster by cluster
    std::uint32_t count = 0;

    Eigen::Vector3f position(std::uint32_t triangle, unsigned corner) const {
        return Eigen::Map<const Eigen::Vector3f>(
            records[triangles[triangle].corners[corner]].position);
    }
    /// To its neighbour across side k, which has to exist.
    float cosine_across(std::uint32_t triangle, unsigned k) const {
        const Node& node = triangles[triangle];
        return node.sign_across(k) * dot(node.normal, triangles[node.neighbours[k]].normal);
    }
    /// Whether a neighbour is in the triangle's plane, by this cosine.
    bool goes_on_flat(std::uint32_t triangle, float cosine) const {
        for (unsigned k = 0; k < 3; ++k)
            if (triangles[triangle].neighbours[k] != kNone && cosine_across(triangle, k) >= cosine)
                return true;
        return false;
    }
};

/// The data outlives the graph. Any number of threads gives the same.
TriangleGraph build_triangle_graph(const ExtractorData& data);

}  // namespace laplacian_lines
