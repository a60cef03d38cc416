// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// A vertex in the middle of an edge, as far as float coordinates can tell.
struct Midpoint {
    std::uint32_t vertex;
    std::array<std::uint32_t, 2> ends;
};

/// Undoes a midpoint subdivision: where all triangles are quarters of larger ones, cut at the
/// middles of their sides, puts these in their place, in the order of their first quarters, and
/// appends the vertices that are left out. Else changes nothing and returns false: at once unless
/// the number of triangles is a multiple of four.
bool undo_subdivision(const std::vector<Eigen::Vector3d>& positions,
                      std::vector<Triangle>& triangles, std::vector<Midpoint>& midpoints);

}  // namespace laplacian_lines
