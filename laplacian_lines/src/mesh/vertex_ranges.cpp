// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vertex_ranges.h"

#include <algorithm>

namespace laplacian_lines {
namespace {

// Large enough that few triangles lie in two ranges, small enough for many threads.
constexpr std::uint32_t kRangeSize = 2048;

struct SharedTriangle {
    std::uint32_t range, triangle;
};

}  // namespace

VertexRanges::VertexRanges(const PreparedMesh& mesh) : mesh_(mesh) {
    const std::size_t ranges = (mesh.size() + kRangeSize - 1) / kRangeSize;
    for (std::size_t r = 0; r <= ranges; ++r) {
        const auto first =
            std::lower_bound(mesh.triangles.begin(), mesh.triangles.end(), r * kRangeSize,
                             [](const Triangle& t, std::size_t vertex) { return t[0] < vertex; });
        first_triangles_.push_back(std::uint32_t(first - mesh.triangles.begin()));
    }
    shared_starts_.assign(ranges + 1, 0);
    collect_shared();
}

/// The first corner is the smallest, so a triangle's other ranges come after that of its own.
void VertexRanges::collect_shared() {
    std::vector<std::vector<SharedTriangle>> found(count());
    in_parallel(count(), [&](std::size_t r) {
        for (std::uint32_t t = first_triangles_[r]; t < first_triangles_[r + 1]; ++t) {
            const Triangle& corners = mesh_.triangles[t];
            const std::uint32_t second = corners[1] / kRangeSize, third = corners[2] / kRangeSize;
            if (second != r) found[r].push_back({second, t});
            if (third != r && third != second) found[r].push_back({third, t});
        }
    });
    for (const auto& list : found)
        for (const SharedTriangle& s : list)
            ++shared_starts_[s.range + 1];
    for (std::size_t r = 0; r < count(); ++r)
        shared_starts_[r + 1] += shared_starts_[r];
    shared_.resize(shared_starts_.back());
    std::vector<std::uint32_t> next = shared_starts_;
    for (const auto& list : found)
        for (const SharedTriangle& s : list)
            shared_[next[s.range]++] = s.triangle;
}

VertexRanges::Range VertexRanges::range(std::size_t r) const {
    Range range;
    range.mesh_ = &mesh_;
    range.begin_ = std::uint32_t(r) * kRangeSize;
    range.end_ = std::min(range.begin_ + kRangeSize, std::uint32_t(mesh_.size()));
    range.first_ = first_triangles_[r];
    range.last_ = first_triangles_[r + 1];
    range.shared_begin_ = shared_.data() + shared_starts_[r];
    range.shared_end_ = shared_.data() + shared_starts_[r + 1];
    return range;
}

}  // namespace laplacian_lines
