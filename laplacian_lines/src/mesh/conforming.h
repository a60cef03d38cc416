// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// Whether a vertex is within a distance of the line between two others, and not that near to them.
bool lies_between(const std::vector<Eigen::Vector3d>& positions, std::uint32_t vertex,
                  std::uint32_t from, std::uint32_t to, double within);

/// How near places are the same, in the unit of the coordinates.
struct Precision {
    double of_floats;       ///< by the largest coordinate
    double of_coordinates;  ///< the same if all are floats, as most files hold; or else smaller
};
Precision precision_of(const std::vector<Eigen::Vector3d>& positions,
                       const std::vector<Triangle>& triangles, double diagonal);

/// Whether each edge is passed equally often in both directions, by sums of 64-bit hashes.
bool is_closed(const std::vector<Triangle>& triangles);

/// Cuts triangles on borders where vertices of other borders lie on their sides, within the
/// precision of the coordinates, if one of the parts is a side of another triangle: programs of
/// solids leave such T-junctions, at which neighbours would not know each other. Neither adds nor
/// moves vertices. `place_of`: first_equal_positions().
void make_conforming(const std::vector<Eigen::Vector3d>& positions,
                     const std::vector<std::uint32_t>& place_of, std::vector<Triangle>& triangles);

/// Texture seams and triangle soups cut closed surfaces open: where two triangles meet, each has
/// vertices of its own at equal coordinates. Closes pairs of borders that run between the same
/// places, where no third one does; holes and sheets that touch or lie on each other stay.
/// Returns for each vertex the one that counts for it, with the smallest number; nothing if no
/// vertex has another. `place_of`: first_equal_positions(). `triangles` have an area.
std::vector<std::uint32_t> stitch_cuts(const std::vector<Eigen::Vector3d>& positions,
                                       const std::vector<std::uint32_t>& place_of,
                                       const std::vector<Triangle>& triangles);

}  // namespace laplacian_lines
