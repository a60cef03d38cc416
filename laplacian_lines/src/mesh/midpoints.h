// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// A vertex in the middle of an edge, within the rounding of floats.
struct Midpoint {
    std::uint32_t vertex;
    std::array<std::uint32_t, 2> ends;
};

/// Undoes a midpoint subdivision: if all triangles are quarters of larger ones, cut at the middles
/// of their sides, replaces them by these, in the order of their first quarters, and appends the
/// vertices that are dropped. Else changes nothing and returns false, at once unless the number of
/// triangles is a multiple of four.
bool undo_subdivision(const std::vector<Eigen::Vector3d>& positions,
                      std::vector<Triangle>& triangles, std::vector<Midpoint>& midpoints);

}  // namespace laplacian_lines
