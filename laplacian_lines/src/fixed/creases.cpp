// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of edges of the mesh whose triangles meet at an angle.
#include <algorithm>
#include <cmath>

#include "fixed/edge_chains.h"
#include "fixed/fixed_kinds.h"
#include "fixed/showing.h"

namespace laplacian_lines {
namespace {

constexpr float kDegrees = 57.29577951308232f;
// Less is not called a crease, whatever the style asks for.
constexpr float kLeastCreaseAngle = 20;  // degrees

Eigen::Vector3f normal(const MeshEdges& mesh, std::uint32_t triangle) {
    const Planes& planes = mesh.planes;
    return {planes.x[triangle], planes.y[triangle], planes.z[triangle]};
}

/// Between the normals of the triangles at an edge, in degrees; 0 at borders.
float angle_at(const MeshEdges& mesh, const MeshEdges::Edge& edge) {
    if (edge.is_border()) return 0;
    const float cosine = normal(mesh, edge.triangles[0]).dot(normal(mesh, edge.triangles[1]));
    return std::acos(std::clamp(cosine, -1.f, 1.f)) * kDegrees;
}

/// A point's `gradient` is the largest angle at its vertex.
LineSet find_creases(const ExtractorData& data) {
    const MeshEdges mesh = find_mesh_edges(rebuild_mesh(data));
    CollectedEdges collected;
    EdgeCollector collector(mesh, collected);
    for (const MeshEdges::Edge& edge : mesh.edges)
        if (const float angle = angle_at(mesh, edge); angle >= kLeastCreaseAngle)
            collector.add(edge, angle);
    return trace_all(data, LineKind::Crease, collector.finish());
}

class Creases : public FixedKindLines {
public:
    explicit Creases(const ExtractorData& data) : lines_(find_creases(data)) {}

    void append(const ExtractorData&, const LocalEye&, const LineStyle& style,
                LineSet& lines) const override {
        const float angle = float(style.crease_angle);
        append_lines(
            lines_, {shortest_line(style), 0}, [](std::size_t) { return true; },
            [&](std::size_t i) { return angle_opacity(lines_.points[i].gradient, angle, 0); },
            lines);
    }

private:
    const LineSet lines_;
};

}  // namespace

const FixedKind creases = fixed_kind<Creases>(LineKind::Crease);

}  // namespace laplacian_lines
