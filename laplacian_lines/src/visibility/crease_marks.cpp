// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/crease_marks.h"

#include <algorithm>
#include <utility>

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

void mark_edge(const SightMesh& mesh, std::uint32_t a, std::uint32_t b, CreaseMarks& marks) {
    const std::uint32_t edge = mesh.edge_between(a, b);
    if (edge != SightMesh::kNoEdge) marks[edge] = true;
}

}  // namespace

const VertexPlaces& CreaseMarker::places() const {
    return *places_.get(
        [&] { return std::make_unique<const VertexPlaces>(mesh_, vertices_of_edges(mesh_)); });
}

/// Other vertices may lie on the way.
void CreaseMarker::mark_along(const Vector3d& begin, const Vector3d& end,
                              CreaseMarks& marks) const {
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
    for (std::size_t i = 1; i < on.size(); ++i)
        mark_edge(mesh_, on[i - 1].second, on[i].second, marks);
}

CreaseMarks CreaseMarker::mark(const std::vector<LineSet>& lines) const {
    CreaseMarks marks;
    for (const LineSet& set : lines)
        for (const Polyline& line : set.lines) {
            if (line.kind != LineKind::Crease) continue;
            marks.resize(mesh_.edge_count());
            for (std::uint32_t i = line.first; i + 1 < line.first + line.count; ++i)
                mark_along(mesh_.local(set.points[i].position.cast<double>()),
                           mesh_.local(set.points[i + 1].position.cast<double>()), marks);
        }
    return marks;
}

}  // namespace laplacian_lines
