// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vertex_ranges.h"

#include <algorithm>

namespace laplacian_lines {

/// A triangle's first corner is its smallest, so the ranges that share it come after its own.
VertexRanges::VertexRanges(const PreparedMesh& mesh)
    : mesh_(mesh),
      shared_(collect<Shared>(mesh.triangles.size(), [&](std::uint32_t t, auto& found) {
          const Triangle& corners = mesh.triangles[t];
          const std::uint32_t first = corners[0] / kSize, second = corners[1] / kSize,
                              third = corners[2] / kSize;
          if (second != first) found.push_back({second, t});
          if (third != first && third != second) found.push_back({third, t});
      })) {
    std::stable_sort(shared_.begin(), shared_.end(),
                     [](const Shared& a, const Shared& b) { return a.range < b.range; });
}

VertexRanges::Range VertexRanges::range(std::uint32_t r) const {
    const auto first_of = [&](std::uint32_t vertex) {
        return std::lower_bound(mesh_.triangles.begin(), mesh_.triangles.end(), vertex,
                                [](const Triangle& t, std::uint32_t v) { return t[0] < v; }) -
               mesh_.triangles.begin();
    };
    const auto shared_of = [&](std::uint32_t range) {
        return std::lower_bound(shared_.begin(), shared_.end(), range,
                                [](const Shared& s, std::uint32_t of) { return s.range < of; }) -
               shared_.begin();
    };
    Range range;
    range.mesh_ = &mesh_;
    range.begin_ = r * kSize;
    range.end_ = std::min(range.begin_ + kSize, std::uint32_t(mesh_.size()));
    range.own_ = mesh_.triangles.data() + first_of(range.begin_);
    range.own_end_ = mesh_.triangles.data() + first_of(range.end_);
    range.shared_ = shared_.data() + shared_of(r);
    range.shared_end_ = shared_.data() + shared_of(r + 1);
    return range;
}

}  // namespace laplacian_lines
