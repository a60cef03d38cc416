// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "clusters/whole_mesh.h"

namespace laplacian_lines {

/// Planes N·(e − w p) = 0 in the homogeneous eye (e, w): N and N·p, one array for each number, so
/// that a pass over all is vectorized.
struct Planes {
    std::vector<float> x, y, z, offset;

    void resize(std::size_t n) {
        for (auto* values : {&x, &y, &z, &offset})
            values->resize(n);
    }
    void set(std::size_t i, const Eigen::Vector3d& normal, const Eigen::Vector3d& p) {
        x[i] = float(normal.x());
        y[i] = float(normal.y());
        z[i] = float(normal.z());
        offset[i] = float(normal.dot(p));
    }
};

/// The mesh's own edges with their triangles, for the lines that follow edges.
struct MeshEdges {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    struct Edge {
        std::array<std::uint32_t, 2> vertices;
        /// Two triangles, or one and kNone where the surface ends: at a border, and where three or
        /// more triangles meet, which is a border of each of them.
        std::array<std::uint32_t, 2> triangles;

        bool is_border() const { return triangles[1] == kNone; }
    };
    std::vector<Edge> edges;
    std::vector<Eigen::Vector3f> positions;  ///< of the vertices, local
    Planes planes;  ///< by triangle: N·(e − w p), positive if its front is seen; N is unit
};

MeshEdges find_mesh_edges(const WholeMesh& mesh);

}  // namespace laplacian_lines
