// SPDX-License-Identifier: GPL-3.0-or-later
// What a crease is, in the order in which it is asked. An edge of the mesh
//  1. turns by 3 degrees on a mesh that was made, by 20 on one that was measured, and is on no
//     rough one, whose edges are those of noise or of voxels;
//  2. on what was measured, parts two sides that differ as much as it turns: is_edge_of_form();
//  3. then is certain if it turns by 40 degrees; of others,
//  4. is no mere diagonal: is_mere_diagonal(),
//  5. turns more than the curved faces on both sides explain: crease_jump(),
//  6. and hangs together with others: drop_unsupported().
// Which of these are long and even enough to be drawn, creases.cpp says.
#include "fixed/crease_edges.h"

#include <algorithm>
#include <cmath>

#include "mesh/flat_faces.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;
using Verdict = CreaseEdge::Verdict;

constexpr float kDegrees = 57.29577951308232f;
// Less is not called a crease: two faces that were made to be one meet at angles as large.
constexpr float kLeastCreaseAngle = 3;  // degrees
// For scans, where anything duller may be noise.
constexpr float kLeastMeasuredAngle = 20;  // degrees
// Shares of the edge's angle that are not explained. Half is between a facet, of which all is, and
// an edge between flat faces, of which nothing is; what goes on from there may be weaker.
constexpr float kStrong = 0.5f, kWeak = 0.25f;

// Of triangular faces.
constexpr std::uint32_t kMostPlaces = 4000;
constexpr std::size_t kMostParts = 256;   // a triangle subdivided four times
constexpr float kSameDirection = 0.999f;  // cosine

/// Whether the flat face of a triangle has sides in but three directions, going around it, as only
/// a triangle has.
bool is_triangle(const TriangleGraph& graph, std::uint32_t triangle, float flat) {
    std::vector<std::uint32_t> parts = {triangle};
    std::vector<float> signs = {1};  // which turn normals to one side
    std::vector<Vector3f> directions;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const TriangleGraph::Node& node = graph.triangles[parts[i]];
        for (unsigned k = 0; k < 3; ++k) {
            const std::uint32_t next = node.neighbours[k];
            if (next != TriangleGraph::kNone && graph.cosine_across(parts[i], k) >= flat) {
                if (std::find(parts.begin(), parts.end(), next) != parts.end()) continue;
                if (parts.size() == kMostParts) return false;
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
            if (directions.size() == 3) return false;
            directions.push_back(direction);
        }
    }
    return directions.size() == 3;
}

/// Of the area of flat faces of several triangles, 0 to 1, the share of those that are triangles
/// themselves: as good as all where the triangles of a scan were subdivided. Flat is what meets at
/// this cosine or more. By some places all over the mesh.
double share_of_triangular_faces(const TriangleGraph& graph, float flat) {
    const std::uint32_t step = graph.count / kMostPlaces + 1;
    double all = 0, triangular = 0;
    for (std::uint32_t triangle = 0; triangle < graph.count; triangle += step) {
        if (!graph.goes_on_flat(triangle, flat)) continue;
        const double area = double(graph.triangles[triangle].area);
        all += area;
        if (is_triangle(graph, triangle, flat)) triangular += area;
    }
    return all > 0 ? triangular / all : 0;
}

class CreaseFinder {
public:
    explicit CreaseFinder(const ExtractorData& data)
        : graph_(build_triangle_graph(data)),
          placed_(place_clusters(data)),
          is_made_(data.flat_share > kMadeShare &&
                   (1 - share_of_triangular_faces(graph_, flat_)) * data.flat_share > kMadeShare) {}

    std::vector<CreaseEdge> run(float least_angle) const {
        std::vector<CreaseEdge> edges = find_bent_edges();
        in_parallel(edges.size(), [&](std::size_t i) { edges[i].verdict = judge(edges[i]); });
        drop_unsupported(edges, is_made_);
        for (CreaseEdge& edge : edges)
            if (edge.verdict != Verdict::Noise)
                edge.shown_up_to =
                    edge.verdict == Verdict::Facet ? edge.angle : std::max(kEdgeAngle, edge.angle);
        const auto is_unused = [&](const CreaseEdge& edge) {
            return edge.verdict == Verdict::Noise || edge.shown_up_to < least_angle;
        };
        edges.erase(std::remove_if(edges.begin(), edges.end(), is_unused), edges.end());
        return edges;
    }

private:
    /// Calls visit(triangle, side, cosine) for each edge of a cluster's triangles once.
    template <class Visit>
    void for_each_edge(std::size_t c, const Visit& visit) const {
        for (unsigned t = 0; t < placed_[c].cluster->triangle_count; ++t) {
            const std::uint32_t triangle = placed_[c].first_triangle + t;
            const TriangleGraph::Node& node = graph_.triangles[triangle];
            for (unsigned k = 0; k < 3; ++k) {
                const std::uint32_t next = node.neighbours[k];
                if (next == TriangleGraph::kNone || next <= triangle) continue;
                if (node.normal.isZero(0) || graph_.triangles[next].normal.isZero(0)) continue;
                visit(t, k, graph_.cosine_across(triangle, k));
            }
        }
    }

    std::vector<CreaseEdge> find_bent_edges() const {
        const float bent =
            std::cos((is_made_ ? kLeastCreaseAngle : kLeastMeasuredAngle) / kDegrees);
        std::vector<std::vector<CreaseEdge>> of_cluster(placed_.size());
        in_parallel(placed_.size(), [&](std::size_t c) {
            for_each_edge(c, [&](unsigned t, unsigned k, float cosine) {
                if (cosine <= bent) of_cluster[c].push_back(make_edge(placed_[c], t, k, cosine));
            });
        });
        std::vector<CreaseEdge> all;
        for (const std::vector<CreaseEdge>& some : of_cluster)
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }

    CreaseEdge make_edge(const PlacedCluster& placed, unsigned t, unsigned k, float cosine) const {
        const std::uint32_t triangle = placed.first_triangle + t;
        const TriangleGraph::Node& node = graph_.triangles[triangle];
        const auto& corners = placed.triangle(t).corners;
        const auto facet = [&](std::uint32_t t) {
            return graph_.goes_on_flat(t, flat_) ? TriangleGraph::kNone : t;
        };
        return {{triangle, k},
                {placed.vertices[corners[k]], placed.vertices[corners[(k + 1) % 3]]},
                {graph_.position(triangle, k), graph_.position(triangle, (k + 1) % 3)},
                {node.normal, node.sign_across(k) * graph_.triangles[node.neighbours[k]].normal},
                {facet(triangle), facet(node.neighbours[k])},
                float(std::acos(std::max(double(cosine), -1.))) * kDegrees};
    }

    Verdict judge(const CreaseEdge& edge) const {
        if (!is_made_ && !is_edge_of_form(graph_, edge)) return Verdict::Noise;
        if (edge.angle >= kEdgeAngle) return Verdict::Certain;
        if (is_mere_diagonal(graph_, edge.side)) return Verdict::Facet;
        const CreaseJump jump = crease_jump(graph_, edge.side, signed_angle(graph_, edge.side));
        if (jump.degrees <= std::max(kLeastCreaseAngle, kWeak * edge.angle)) return Verdict::Facet;
        const bool is_strong = jump.degrees > kStrong * edge.angle;
        if (!jump.is_clear) return is_strong ? Verdict::Unclear : Verdict::Facet;
        return is_strong ? Verdict::Strong : Verdict::Weak;
    }

    const float flat_ = std::cos(kFlat / kDegrees);
    const TriangleGraph graph_;
    const std::vector<PlacedCluster> placed_;
    const bool is_made_;
};

}  // namespace

std::vector<CreaseEdge> find_crease_edges(const ExtractorData& data, float least_angle) {
    if (data.is_rough) return {};
    return CreaseFinder(data).run(least_angle);
}

}  // namespace laplacian_lines
