// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "clusters/planes.h"
#include "clusters/whole_mesh.h"

namespace laplacian_lines {

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
