// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/corner_table.h"

#include <numeric>

#include "system/large_array.h"

namespace laplacian_lines {

CornerTable::CornerTable(const std::vector<Triangle>& triangles, std::size_t vertices)
    : across_(large_array<std::uint32_t>(3 * triangles.size())) {
    const auto counts = visit_edges<std::size_t>(
        across_.size(), vertices, [&](std::uint32_t side) { return edge_of(triangles, side); },
        [&](const std::uint32_t* begin, const std::uint32_t* end, std::size_t& edges) {
            ++edges;
            for (const std::uint32_t* side = begin; side != end; ++side)
                across_[*side] = end - begin == 2   ? begin[side == begin]
                                 : end - begin == 1 ? kBorder
                                                    : kMany;
        });
    edge_count_ = std::accumulate(counts.begin(), counts.end(), std::size_t(0));
}

}  // namespace laplacian_lines
