// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "visibility/sight_mesh.h"

namespace laplacian_lines {

/// Drops triangles without height, and all but one of those with the same corners.
void build_edges(SightMesh& mesh);

/// Adds sides of triangles; `gone` are edges to remove, ascending.
void change_edges(std::vector<LooseSide> sides, const std::vector<std::uint32_t>& gone,
                  SightMesh& mesh);

}  // namespace laplacian_lines
