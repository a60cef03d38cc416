// SPDX-License-Identifier: GPL-3.0-or-later
// Creases come as lines, from another preparation of the mesh, so their edges are found by place:
//  1. The vertices near each segment of a crease, sorted along it.
//  2. The edges between neighbours in this order. Surfaces may touch there, each with vertices of
//     its own at the same place, so a vertex has several neighbours.
#include "visibility/crease_marks.h"

#include <algorithm>
#include <utility>

namespace laplacian_lines {

using Eigen::Vector3d;

constexpr std::size_t kNeighbours = 4;  // tried after each vertex along a segment

/// The places of all vertices of edges.
const VertexLookup& CreaseMarker::places() const {
    return *places_.get([&] {
        std::vector<bool> are_used(mesh_.positions.size());
        for (std::size_t e = 0; e < mesh_.edge_count(); ++e)
            for (const std::uint32_t v : mesh_.edges[e].vertices)
                are_used[v] = true;
        return std::make_unique<const VertexLookup>(mesh_,
                                                    [&](std::uint32_t v) { return are_used[v]; });
    });
}

/// Appends the edges along a segment; they may end at vertices within it.
void CreaseMarker::find_along(const Vector3d& begin, const Vector3d& end,
                              std::vector<std::uint32_t>& edges) const {
    const double reach = 2 * mesh_.line_precision + mesh_.precision, length = (end - begin).norm();
    if (!(length > 0)) return;
    const Vector3d direction = (end - begin) / length;
    std::vector<std::pair<double, std::uint32_t>> on;
    places().visit_along(begin, end, reach, [&](std::uint32_t v) {
        const Vector3d& p = mesh_.positions[v];
        const double along = std::clamp(direction.dot(p - begin), 0., length);
        if ((p - begin - along * direction).norm() <= reach) on.emplace_back(along, v);
    });
    std::sort(on.begin(), on.end());
    on.erase(std::unique(on.begin(), on.end()), on.end());
    for (std::size_t i = 0; i < on.size(); ++i)
        for (std::size_t k = i + 1; k < std::min(on.size(), i + 1 + kNeighbours); ++k) {
            const std::uint32_t edge = mesh_.edge_between(on[i].second, on[k].second);
            if (edge != VisibilityMesh::kNoEdge) edges.push_back(edge);
        }
}

CreaseMarks CreaseMarker::mark(const std::vector<Segment>& creases) const {
    if (creases.empty()) return {};
    CreaseMarks marks(mesh_.edge_count());
    const auto find = [&](std::uint32_t i, std::vector<std::uint32_t>& edges) {
        find_along(mesh_.local(creases[i][0]), mesh_.local(creases[i][1]), edges);
    };
    for (const std::uint32_t edge : collect<std::uint32_t>(creases.size(), find))
        marks[edge] = true;
    return marks;
}

std::shared_ptr<const CreaseMarks> CreaseMarker::mark(const std::vector<LineSet>& lines) const {
    std::vector<Segment> creases;
    for (const LineSet& set : lines)
        for (const Polyline& line : set.lines)
            for (std::uint32_t i = 1; line.kind == LineKind::Crease && i < line.count; ++i)
                creases.push_back({set.position(set.points[line.first + i - 1]),
                                   set.position(set.points[line.first + i])});
    const std::lock_guard<std::mutex> lock(mutex_);
    if (creases != creases_) {
        marks_ = std::make_shared<const CreaseMarks>(mark(creases));
        creases_ = std::move(creases);
    }
    return marks_;
}

}  // namespace laplacian_lines
