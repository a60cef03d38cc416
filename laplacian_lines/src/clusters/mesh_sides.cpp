// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/mesh_sides.h"

#include <utility>

namespace laplacian_lines {
namespace {

/// The mesh's vertices at the ends of a side, in its direction.
std::array<std::uint32_t, 2> ends(const PlacedCluster& placed, unsigned triangle, unsigned side) {
    const auto& corners = placed.triangle(triangle).corners;
    return {placed.vertices[corners[side]], placed.vertices[corners[(side + 1) % 3]]};
}

}  // namespace

MeshSides::MeshSides(const ExtractorData& data, const std::vector<PlacedCluster>& placed)
    : data_(data), placed_(placed), shared_(data.border_edge_count) {
    for (std::uint32_t c = 0; c < placed.size(); ++c)
        for (unsigned t = 0; t < placed[c].cluster->triangle_count; ++t)
            for (unsigned k = 0; k < 3; ++k) {
                const MeshSide side = {c, std::uint8_t(t), std::uint8_t(k)};
                if (!is_shared(side)) continue;
                Sides& sides = shared_[edge_number(side)];
                sides[sides[0].exists()] = side;
            }
}

MeshSide MeshSides::across(const MeshSide& from) const {
    const PlacedCluster& placed = placed_[from.cluster];
    const std::uint8_t neighbour = placed.triangle(from.triangle).neighbours[from.side];
    if (neighbour == kNoNeighbour) return {};
    std::array there = ends(placed, from.triangle, from.side);
    std::swap(there[0], there[1]);
    const auto found = [&](const MeshSide& side) {
        return ends(placed_[side.cluster], side.triangle, side.side) == there;
    };
    if (is_shared(from)) {
        for (const MeshSide& side : shared_[edge_number(from)])
            if (side.exists() && found(side)) return side;
        return {};
    }
    for (std::uint8_t k = 0; k < 3; ++k)
        if (const MeshSide side = {from.cluster, neighbour, k}; found(side)) return side;
    return {};
}

bool MeshSides::is_shared(const MeshSide& side) const {
    const PlacedCluster& placed = placed_[side.cluster];
    const std::uint8_t neighbour = placed.triangle(side.triangle).neighbours[side.side];
    return neighbour != kNoNeighbour && neighbour >= placed.cluster->triangle_count;
}

std::uint32_t MeshSides::edge_number(const MeshSide& side) const {
    const PlacedCluster& placed = placed_[side.cluster];
    const unsigned edge =
        placed.triangle(side.triangle).neighbours[side.side] - placed.cluster->triangle_count;
    return data_.border_edges[placed.cluster->first_border_edge + edge];
}

}  // namespace laplacian_lines
