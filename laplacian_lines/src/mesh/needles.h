// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// Flips the longest side of needles that are folded back over it, if that leaves none: triangles
/// narrower than 1e-4 D and than a hundredth of their length. They would be back faces that are no
/// part of the form. Positions are in D.
void unfold_needles(const std::vector<Eigen::Vector3d>& positions,
                    std::vector<Triangle>& triangles);

/// By vertex: the smallest of those that sides of at most this length connect with it; empty if no
/// side is so short.
std::vector<std::uint32_t> ends_of_short_sides(const std::vector<Eigen::Vector3d>& positions,
                                               double most_length,
                                               const std::vector<Triangle>& triangles);

/// Flips the longest sides of triangles that are at most so high, where they have one neighbour
/// there and both new triangles are higher than the low one and face as the neighbour did: dropping
/// it would leave a slit. A triangle that only a flip makes low may stay.
void flip_low_triangles(const std::vector<Eigen::Vector3d>& positions, double least_height,
                        std::vector<Triangle>& triangles);

}  // namespace laplacian_lines
