// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/crease_criteria.h"

#include <algorithm>

#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;

constexpr std::uint32_t kMostPlaces = 4000;
constexpr std::size_t kMostParts = 256;   // a triangle subdivided four times
constexpr float kSameDirection = 0.999f;  // cosine

/// How many triangles are in the flat face of one, if that face has sides in but three directions,
/// going around it, as only a triangle has; else 0.
std::size_t parts_of_triangle(const TriangleGraph& graph, std::uint32_t triangle, float flat) {
    std::vector<std::uint32_t> parts = {triangle};
    std::vector<float> signs = {1};  // which turn normals to one side
    std::vector<Vector3f> directions;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const TriangleGraph::Node& node = graph.triangles[parts[i]];
        for (unsigned k = 0; k < 3; ++k) {
            const std::uint32_t next = node.neighbours[k];
            if (next != TriangleGraph::kNone && graph.cosine_across(parts[i], k) >= flat) {
                if (std::find(parts.begin(), parts.end(), next) != parts.end()) continue;
                if (parts.size() == kMostParts) return 0;
                parts.push_back(next);
                signs.push_back(signs[i] * node.sign_across(k));
                continue;
            }
            const Vector3f side =
                graph.position(parts[i], (k + 1) % 3) - graph.position(parts[i], k);
            const Vector3f direction = signs[i] * unit(side);
            const auto is_same = [&](const Vector3f& d) {
                return dot(d, direction) > kSameDirection;
            };
            if (std::any_of(directions.begin(), directions.end(), is_same)) continue;
            if (directions.size() == 3) return 0;
            directions.push_back(direction);
        }
    }
    return directions.size() == 3 ? parts.size() : 0;
}

}  // namespace

TriangularFaces find_triangular_faces(const TriangleGraph& graph, float flat) {
    const std::uint32_t count = graph.count, step = count / kMostPlaces + 1;
    double all = 0, triangular = 0, parts = 0;  // areas, and their sum by parts
    for (std::uint32_t triangle = 0; triangle < count; triangle += step) {
        if (!graph.goes_on_flat(triangle, flat)) continue;
        const double area = double(graph.triangles[triangle].area);
        all += area;
        if (const std::size_t of_face = parts_of_triangle(graph, triangle, flat)) {
            triangular += area;
            parts += area * double(of_face);
        }
    }
    return triangular > 0 ? TriangularFaces{triangular / all, parts / triangular}
                          : TriangularFaces();
}

}  // namespace laplacian_lines
