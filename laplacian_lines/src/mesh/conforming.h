// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "mesh/sides_by_edge.h"

namespace laplacian_lines {

/// The triangles with each corner v replaced by by[v].
std::vector<Triangle> with_places(std::vector<Triangle> triangles,
                                  const std::vector<std::uint32_t>& by);

/// Whether a vertex is within a distance of the line between two others, and more than that along
/// it from both.
bool lies_between(const std::vector<Eigen::Vector3d>& positions, std::uint32_t vertex,
                  std::uint32_t from, std::uint32_t to, double within);

/// Distances up to which positions count as equal, in the unit of the coordinates.
struct Precision {
    double of_floats;       ///< by the largest coordinate
    double of_coordinates;  ///< the same if all are floats, as in most files; else at most that
};
/// Of the positions in the box of those that triangles use.
Precision precision_of(const std::vector<Eigen::Vector3d>& positions,
                       const Eigen::AlignedBox3d& box);

/// Whether triangles pass each edge equally often in both directions, by sums of 64-bit hashes.
bool is_closed(const std::vector<Triangle>& triangles);

/// Whether each triangle is there as often facing one way as the other: is_closed() holds for
/// these, but they are the two sides of one surface and enclose nothing.
bool are_two_sided(const std::vector<Triangle>& triangles);

/// Edges of one triangle.
std::vector<Edge> border_edges(const std::vector<Triangle>& triangles, std::size_t vertices);

/// Of the diagonal: patches of CAD programs and pieces of scans are as far apart; if it is 100 mm
/// on paper, a fiftieth of a pen of .25 mm.
constexpr double kCrack = 5e-5;

/// Distances within which vertices of borders count as at one place, in the positions' unit.
struct Nearness {
    double precision, crack;  ///< the second less where sides are short
};
Nearness nearness_of(const std::vector<Eigen::Vector3d>& positions,
                     const std::vector<Triangle>& triangles);

/// Joins a surface at its cracks and T-junctions, as CAD programs and scanners leave them: returns
/// for each vertex the first one at its place, which at borders need not be the same position,
/// drops the copies of a doubled mesh, and cuts triangles on borders where vertices of other
/// borders lie on their sides, if one of the parts is a side of another triangle. Neither adds nor
/// moves vertices.
std::vector<std::uint32_t> make_conforming(const std::vector<Eigen::Vector3d>& positions,
                                           const Nearness& near, std::vector<Triangle>& triangles);

/// Closes cuts: at texture seams and in triangle soups, triangles that meet have vertices of their
/// own at one place. Merges pairs of borders that run between the same places, where no third one
/// does; holes, and surfaces that touch or lie on each other, stay. Returns the representative of
/// each vertex, that with the smallest number; nothing if all represent themselves. `place_of`: see
/// make_conforming(). `triangles` have an area.
std::vector<std::uint32_t> stitch_cuts(const std::vector<Eigen::Vector3d>& positions,
                                       const std::vector<std::uint32_t>& place_of,
                                       const std::vector<Triangle>& triangles);

}  // namespace laplacian_lines
