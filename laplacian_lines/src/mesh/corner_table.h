// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/sides_by_edge.h"

namespace laplacian_lines {

/// Which triangles meet at edges (J. Rossignac, "3D Compression Made Simple", 2001, but by sides
/// instead of the corners opposite them). Side 3 t + k runs from corner k of triangle t to the
/// next:
///
///              c
///            /   \             side 0: a b, across it side 3 of the triangle b a d,
///          2       1           or side 3 of a b d if that has the opposite orientation
///        /     0     \         .
///      a ------------- b
///        \     3     /
///          \       /
///              d
class CornerTable {
public:
    static constexpr std::uint32_t kBorder = 0xffffffffu;  ///< across an edge of one triangle
    static constexpr std::uint32_t kMany = 0xfffffffeu;    ///< across an edge of more than two

    /// No triangle has a corner twice. The number of threads does not matter.
    CornerTable(const std::vector<Triangle>& triangles, std::size_t vertices);

    std::size_t side_count() const { return across_.size(); }
    std::size_t edge_count() const { return edge_count_; }
    /// The other side of its edge, or kBorder or kMany.
    std::uint32_t across(std::uint32_t side) const { return across_[side]; }
    bool has_neighbour(std::uint32_t side) const { return across_[side] < kMany; }

private:
    std::vector<std::uint32_t> across_;
    std::size_t edge_count_;
};

}  // namespace laplacian_lines
