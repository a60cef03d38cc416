// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "clusters/extractor_data.h"

namespace laplacian_lines {

/// A side of a triangle of a cluster, from corner `side` to the next.
struct MeshSide {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::uint32_t cluster = kNone;  ///< kNone: there is no such side
    std::uint8_t triangle = 0;
    std::uint8_t side = 0;

    bool exists() const { return cluster != kNone; }
};

/// What lies across the sides of triangles, over the borders of clusters too.
class MeshSides {
public:
    /// Both are kept by reference.
    MeshSides(const ExtractorData& data, const std::vector<PlacedCluster>& placed);

    /// The same edge as a side of the triangle beyond; none where the surface ends, at edges of
    /// more than two triangles, and where the triangle beyond has the opposite orientation.
    MeshSide across(const MeshSide& from) const;

private:
    using Sides = std::array<MeshSide, 2>;  // of an edge that clusters share

    bool is_shared(const MeshSide& side) const;
    std::uint32_t edge_number(const MeshSide& shared) const;

    const ExtractorData& data_;
    const std::vector<PlacedCluster>& placed_;
    std::vector<Sides> shared_;  // as ExtractorData::border_edges numbers them
};

}  // namespace laplacian_lines
