// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// Texture seams and triangle soups cut closed surfaces open: where two triangles meet, each has
/// vertices of its own at equal coordinates. Closes pairs of borders that run between the same
/// places, where no third one does; holes and sheets that touch or lie on each other stay.
/// Returns for each vertex the one that counts for it, with the smallest number; nothing if no
/// vertex has another. `place_of`: first_equal_positions(). `triangles` have an area.
std::vector<std::uint32_t> stitch_cuts(const std::vector<Eigen::Vector3d>& positions,
                                       const std::vector<std::uint32_t>& place_of,
                                       const std::vector<Triangle>& triangles);

}  // namespace laplacian_lines
