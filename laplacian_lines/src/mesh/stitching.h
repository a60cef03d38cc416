// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// Whether each edge is passed as often in one direction as in the other. A border would have to
/// hit one sum of 2^64.
bool is_closed(const std::vector<Triangle>& triangles);

/// Files with texture seams and triangle soups cut a closed surface open: where two of its
/// triangles meet, each has vertices of its own at equal coordinates. Finds what closes these cuts:
/// pairs of borders that go from one place to another in opposite directions, where no third one
/// does. So borders of holes stay, and so do sheets that lie upon or touch each other. Returns for
/// each vertex the one that counts for it, the smallest of its number; nothing if every vertex
/// counts for itself. `triangles` have an area.
std::vector<std::uint32_t> stitch_cuts(const std::vector<Eigen::Vector3d>& positions,
                                       const std::vector<Triangle>& triangles);

}  // namespace laplacian_lines
