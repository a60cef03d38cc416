// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/crease_surroundings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;

constexpr float kDegrees = 57.29577951308232f;
constexpr std::size_t kMostTriangles = 24;  // of a side
constexpr float kLeastReach = 0.01f;        // D
constexpr float kHeights = 2.5f;            // the reach in heights of the first triangle
constexpr float kPassable = 35;             // degrees; less parts no faces of the form
constexpr float kMuchFlatter = 1 / 3.f;     // of the angle at the edge
constexpr float kSameWay = 0.4f;            // least cosine of edges that tell of the same bend
// What is left of an edge's angle between the mean normals of its sides, at least.
constexpr float kConfirmed = 0.6f;
constexpr float kConfirmedAnyway = 40;  // degrees
constexpr float kTimesRoughness = 6;    // the least angle of an edge
constexpr float kCalm = 2;         // degrees of roughness; so smooth is what was made, not measured
constexpr float kLong = 0.02;      // D; edges this long are no noise
constexpr int kFewEdges = 8;       // too few to tell bending to and fro from one way
constexpr float kLeastSum = 0.2f;  // of the area; where normals cancel, they have no mean

float cosine_of(float degrees) {
    return std::cos(degrees / kDegrees);
}

float angle_between(const Vector3f& a, const Vector3f& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * kDegrees;
}

/// One side of a bent edge, that of a triangle.
class EdgeSide {
public:
    /// Of the edge's own triangle, or of the one beyond. Normals are turned to agree with the
    /// edge's own triangle.
    EdgeSide(const TriangleGraph& graph, const BentEdge& edge, bool beyond,
             VisitedTriangles& visited)
        : graph_(graph), visited_(visited) {
        const TriangleGraph::Node& own = graph.triangles[edge.triangle];
        const std::uint32_t other = own.neighbours[edge.side];
        const float sign = own.sign_across(edge.side);
        start_ = beyond ? other : edge.triangle;
        not_ = beyond ? edge.triangle : other;
        sign_ = beyond ? sign : 1;
        const Vector3f a = graph.position(edge.triangle, edge.side);
        const Vector3f b = graph.position(edge.triangle, (edge.side + 1) % 3);
        middle_ = (a + b) / 2;
        along_ = b - a;
        length_ = along_.norm();
        if (length_ > 0) along_ /= length_;
        const Vector3f inwards = own.normal.cross(along_);
        const Vector3f outwards = sign * graph.triangles[other].normal.cross(-along_);
        away_ = beyond ? outwards - inwards : inwards - outwards;
    }

    /// Visits the triangles from the edge on, in rings, as far as `passes(triangle, side)` for the
    /// way from one to the next and `holds(triangle)`, and while visit(triangle, sign) is true.
    /// Returns whether it always was.
    template <class Passes, class Holds, class Visit>
    bool visit(const Passes& passes, const Holds& holds, const Visit& visit) {
        visited_.assign(1, start_);
        signs_[0] = sign_;
        for (std::size_t i = 0; i < visited_.size(); ++i) {
            const std::uint32_t triangle = visited_[i];
            if (!visit(triangle, signs_[i])) return false;
            const TriangleGraph::Node& node = graph_.triangles[triangle];
            for (unsigned k = 0; k < 3 && visited_.size() < kMostTriangles; ++k) {
                const std::uint32_t next = node.neighbours[k];
                if (next == TriangleGraph::kNone || next == not_ ||
                    std::find(visited_.begin(), visited_.end(), next) != visited_.end() ||
                    !passes(triangle, k) || !holds(next))
                    continue;
                signs_[visited_.size()] = signs_[i] * node.sign_across(k);
                visited_.push_back(next);
            }
        }
        return true;
    }

    /// Normal times area, twice.
    Vector3f area(std::uint32_t triangle) const {
        const Vector3f a = graph_.position(triangle, 0);
        return (graph_.position(triangle, 1) - a).cross(graph_.position(triangle, 2) - a);
    }
    Vector3f centre(std::uint32_t triangle) const {
        return (graph_.position(triangle, 0) + graph_.position(triangle, 1) +
                graph_.position(triangle, 2)) /
               3;
    }
    float height() const { return length_ > 0 ? area(start_).norm() / length_ : 0; }
    std::uint32_t start() const { return start_; }
    std::uint32_t beyond_edge() const { return not_; }

    /// Whether a place is on this side and within reach.
    bool is_near(const Vector3f& p, float across, float along) const {
        const Vector3f way = p - middle_;
        return way.dot(away_) > 0 && std::abs(way.dot(along_)) <= length_ / 2 + along &&
               way.squaredNorm() <= (across + along + length_ / 2) * (across + along + length_ / 2);
    }
    float length() const { return length_; }
    const Vector3f& middle() const { return middle_; }
    const Vector3f& along() const { return along_; }

private:
    const TriangleGraph& graph_;
    VisitedTriangles& visited_;
    std::uint32_t start_, not_;
    float sign_, length_;
    Vector3f middle_, along_, away_;
    float signs_[kMostTriangles];
};

/// Positive where the surface is convex at a side of a triangle.
float bend_at(const TriangleGraph& graph, std::uint32_t triangle, unsigned k) {
    const std::uint32_t next = graph.triangles[triangle].neighbours[k];
    Vector3f centre = Vector3f::Zero();
    for (unsigned corner = 0; corner < 3; ++corner)
        centre += graph.position(next, corner) / 3;
    return -graph.triangles[triangle].normal.dot(centre - graph.position(triangle, k));
}

/// What the surface is like on one side.
struct SideSum {
    Vector3f normals = Vector3f::Zero();  ///< times areas, as the edge's own triangle has them
    float area = 0;
    float bends = 0, sizes = 0, squares = 0;  ///< of the angles at edges inside, signed; radians
    int edges = 0, triangles = 0;
    bool is_long = false;

    /// How much the surface bends to and fro, degrees.
    float roughness() const {
        if (!(sizes > 0)) return 0;
        const float size = std::sqrt(squares / float(edges)) * kDegrees;
        return edges < kFewEdges && !is_long ? size : size * (1 - std::abs(bends) / sizes);
    }
    /// Whether the surface looks made, not measured.
    bool is_calm() const {
        if (is_long && triangles < 4) return true;
        return edges > 0 && roughness() < kCalm;
    }
};

/// Whether the mean normals of two sides differ about as much as the normals at the edge do.
bool turns(const SideSum& here, const SideSum& there, float angle) {
    if (!(here.normals.norm() > kLeastSum * here.area) ||
        !(there.normals.norm() > kLeastSum * there.area))
        return true;
    return angle_between(here.normals, there.normals) >=
           std::min(kConfirmed * angle, kConfirmedAnyway);
}

/// `passable`: the least cosine at edges that are crossed.
SideSum sum_of_side(const TriangleGraph& graph, const BentEdge& edge, bool beyond, float passable,
                    VisitedTriangles& memory) {
    EdgeSide side(graph, edge, beyond, memory);
    const float height = side.height();
    const float across = std::max(kLeastReach, kHeights * height);
    const float along = std::max(kLeastReach, kHeights * std::min(height, side.length()));
    SideSum sum;
    sum.is_long = side.length() > kLong;
    side.visit([&](std::uint32_t t, unsigned k) { return graph.cosine_across(t, k) >= passable; },
               [&](std::uint32_t t) { return side.is_near(side.centre(t), across, along); },
               [&](std::uint32_t t, float sign) {
                   const Vector3f of_triangle = side.area(t);
                   sum.normals += sign * of_triangle;
                   sum.area += of_triangle.norm();
                   ++sum.triangles;
                   for (unsigned k = 0; k < 3; ++k) {
                       const std::uint32_t next = graph.triangles[t].neighbours[k];
                       if (next == TriangleGraph::kNone) continue;
                       const float cosine = graph.cosine_across(t, k);
                       if (cosine < passable) continue;
                       const float angle = std::sqrt(std::max(2 - 2 * cosine, 0.f));
                       sum.bends += sign * bend_at(graph, t, k) > 0 ? angle : -angle;
                       sum.sizes += angle;
                       sum.squares += angle * angle;
                       ++sum.edges;
                   }
                   return true;
               });
    return sum;
}

/// An edge beside the one in question that says that the surface is bent there as well.
bool bends_alike(const TriangleGraph& graph, const EdgeSide& side, std::uint32_t triangle,
                 unsigned k) {
    const Vector3f a = graph.position(triangle, k), b = graph.position(triangle, (k + 1) % 3);
    const Vector3f way = (a + b) / 2 - side.middle(), edge = b - a;
    const float along = way.dot(side.along());
    return 2 * along * along <= way.squaredNorm() &&
           std::abs(edge.dot(side.along())) >= kSameWay * edge.norm();
}

bool is_flat_beside(const TriangleGraph& graph, const BentEdge& edge, bool beyond,
                    VisitedTriangles& memory) {
    static const float strong = cosine_of(kEdgeAngle);
    const float flat = cosine_of(edge.angle * kMuchFlatter);
    const bool convex = bend_at(graph, edge.triangle, edge.side) > 0;
    EdgeSide side(graph, edge, beyond, memory);
    return side.visit(
        [&](std::uint32_t t, unsigned k) { return graph.cosine_across(t, k) >= flat; },
        [](std::uint32_t) { return true; },
        [&](std::uint32_t t, float sign) {
            for (unsigned k = 0; k < 3; ++k) {
                const std::uint32_t next = graph.triangles[t].neighbours[k];
                if (next == TriangleGraph::kNone ||
                    (t == side.start() && next == side.beyond_edge()))
                    continue;
                const float cosine = graph.cosine_across(t, k);
                if (cosine < flat && cosine > strong &&
                    (sign * bend_at(graph, t, k) > 0) == convex && bends_alike(graph, side, t, k))
                    return false;
            }
            return true;
        });
}

}  // namespace

bool is_edge_of_form(const TriangleGraph& graph, const BentEdge& edge, VisitedTriangles& memory) {
    static const float passable = cosine_of(kPassable);
    const SideSum here = sum_of_side(graph, edge, false, passable, memory),
                  there = sum_of_side(graph, edge, true, passable, memory);
    const float roughness = std::max(here.roughness(), there.roughness());
    if (edge.angle < kTimesRoughness * roughness) return false;
    if (!turns(here, there, edge.angle)) return false;
    if (here.is_calm() && there.is_calm()) return true;
    return turns(sum_of_side(graph, edge, false, -1, memory),
                 sum_of_side(graph, edge, true, -1, memory), edge.angle);
}

bool is_bent_alone(const TriangleGraph& graph, const BentEdge& edge, VisitedTriangles& memory) {
    return is_flat_beside(graph, edge, false, memory) && is_flat_beside(graph, edge, true, memory);
}

}  // namespace laplacian_lines
