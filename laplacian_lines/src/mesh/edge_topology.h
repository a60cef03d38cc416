// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// The undirected edges of a triangle list, each once, for any topology.
struct EdgeTopology {
    std::size_t edge_count = 0;
    std::vector<std::array<std::uint32_t, 3>> edges_of_triangle;  ///< k: opposite corner k
};

/// Edges are numbered by their smaller vertex, so that they are stored near their vertices.
EdgeTopology build_edge_topology(std::size_t vertex_count, const std::vector<Triangle>& triangles);

}  // namespace laplacian_lines
