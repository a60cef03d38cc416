// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/crease_criteria.h"

#include <Eigen/Geometry>
#include <cmath>

#include "fixed/edge_side.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;

constexpr float kDegrees = 57.29577951308232f;

// How far a side reaches.
constexpr float kLeastReach = 0.01f;  // D
constexpr float kHeights = 2.5f;      // of the triangle at the edge
constexpr float kPassable = 35;       // degrees; what is bent more parts faces of the form

// When the mean normals of two sides differ enough: by a share of the edge's angle.
constexpr float kConfirmed = 0.6f;
constexpr float kConfirmedAnyway = 40;  // degrees
constexpr float kLeastSum = 0.2f;       // of the area; normals that cancel have no mean

// When bending to and fro is that of a rough surface.
constexpr float kTimesRoughness = 6;  // the least angle of an edge
constexpr float kCertainly = 1.5f;    // times too rough: what is still to come does not help
constexpr float kCalm = 2;            // degrees; so smooth is what was made, not measured
constexpr float kFewEdges = 8;        // too few to tell bending to and fro from bending one way
constexpr float kLong = 0.02f;        // D; edges this long are no noise
constexpr int kFewTriangles = 4;      // of a side, as large faces have them

float cosine_of(float degrees) {
    return std::cos(degrees / kDegrees);
}

float angle_between(const Vector3f& a, const Vector3f& b) {
    return arc_tangent(length_of(a.cross(b)), dot(a, b)) * kDegrees;
}

/// Positive where the surface is convex at a side of a triangle.
float bend_at(const TriangleGraph& graph, std::uint32_t triangle, unsigned k) {
    const TriangleGraph::Node& node = graph.triangles[triangle];
    return dot(node.normal, node.centre - graph.triangles[node.neighbours[k]].centre);
}

/// What the surface is like on one side.
class SideSum {
public:
    /// From a side of an edge as far as edges have at least the cosine `passable`, which may end
    /// where the surface is too rough for an edge of this angle.
    SideSum(const TriangleGraph& graph, const EdgeSide& side, float passable, float angle)
        : graph_(graph),
          passable_(passable),
          cuts_(std::sqrt(float(graph.subdivision))),
          is_long_(cuts_ * side.length() > kLong) {
        const float height = cuts_ * side.height();
        const float across = std::max(kLeastReach, kHeights * height);
        const float along =
            std::max(kLeastReach, kHeights * std::min(height, cuts_ * side.length()));
        side.visit(
            [&](std::uint32_t t, unsigned k) { return graph.cosine_across(t, k) >= passable; },
            [&](std::uint32_t t) { return side.is_near(graph.triangles[t].centre, across, along); },
            [&](std::uint32_t t, float sign) {
                add(t, sign);
                return has_few_edges() || !is_too_rough(angle / kCertainly);
            });
    }

    bool is_too_rough(float angle) const { return angle < kTimesRoughness * roughness(); }

    /// Whether the surface looks made, not measured.
    bool is_calm() const {
        if (is_long_ && triangles_ < kFewTriangles) return true;
        return edges_ > 0 && roughness() < kCalm;
    }

    /// Whether the mean normals of two sides differ about as much as those at the edge do.
    static bool differ(const SideSum& here, const SideSum& there, float angle) {
        if (!here.has_mean() || !there.has_mean()) return true;
        return angle_between(here.normals_, there.normals_) >=
               std::min(kConfirmed * angle, kConfirmedAnyway);
    }

private:
    bool has_few_edges() const { return float(edges_) < kFewEdges * cuts_; }

    void add(std::uint32_t triangle, float sign) {
        static const float flat = cosine_of(kFlat);
        const TriangleGraph::Node& node = graph_.triangles[triangle];
        normals_ += sign * node.area * node.normal;
        area_ += node.area;
        ++triangles_;
        for (unsigned k = 0; k < 3; ++k) {
            if (node.neighbours[k] == TriangleGraph::kNone) continue;
            const float cosine = graph_.cosine_across(triangle, k);
            if (cosine < passable_ || (graph_.subdivision > 1 && cosine >= flat)) continue;
            const float square = std::max(2 - 2 * cosine, 0.f);  // of the angle, nearly
            const float size = std::sqrt(square);
            bends_ += sign * bend_at(graph_, triangle, k) > 0 ? size : -size;
            sizes_ += size;
            squares_ += square;
            ++edges_;
        }
    }

    /// How much the surface bends to and fro, degrees.
    float roughness() const {
        if (!(sizes_ > 0)) return 0;
        const float size = std::sqrt(squares_ / float(edges_)) * kDegrees;
        return has_few_edges() && !is_long_ ? size : size * (1 - std::abs(bends_) / sizes_);
    }

    bool has_mean() const { return length_of(normals_) > kLeastSum * area_; }

    const TriangleGraph& graph_;
    const float passable_;
    const float cuts_;  // into which an edge was cut when the mesh was subdivided
    const bool is_long_;
    Vector3f normals_ = Vector3f::Zero();  // times areas, as the edge's own triangle has them
    float area_ = 0;
    float bends_ = 0, sizes_ = 0, squares_ = 0;  // of the angles at edges, signed; radians
    int edges_ = 0, triangles_ = 0;
};

}  // namespace

bool is_edge_of_form(const TriangleGraph& graph, const BentEdge& edge) {
    static const float passable = cosine_of(kPassable);
    constexpr float anything = -2;
    const EdgeSide own(graph, edge, false), other(graph, edge, true);
    const SideSum here(graph, own, passable, edge.angle);
    if (here.is_too_rough(edge.angle)) return false;
    const SideSum there(graph, other, passable, edge.angle);
    if (there.is_too_rough(edge.angle) || !SideSum::differ(here, there, edge.angle)) return false;
    if (here.is_calm() && there.is_calm()) return true;
    constexpr float whatever = 1e6f;
    return SideSum::differ(SideSum(graph, own, anything, whatever),
                           SideSum(graph, other, anything, whatever), edge.angle);
}

}  // namespace laplacian_lines
