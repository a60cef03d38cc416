// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "visibility/sight_mesh.h"

namespace laplacian_lines {

/// Not yet grouped by edges.
struct LooseSide {
    std::uint32_t vertices[2];  // ascending
    std::uint32_t triangle;
    bool is_reversed;
};

inline LooseSide side_between(std::uint32_t from, std::uint32_t to, std::uint32_t triangle) {
    return {{std::min(from, to), std::max(from, to)}, triangle, from > to};
}

/// Drops triangles without height, and all but one of those with the same corners.
void build_edges(SightMesh& mesh);

/// Adds sides of triangles; `gone` are edges to remove, ascending.
void change_edges(const std::vector<LooseSide>& sides, const std::vector<std::uint32_t>& gone,
                  SightMesh& mesh);

}  // namespace laplacian_lines
