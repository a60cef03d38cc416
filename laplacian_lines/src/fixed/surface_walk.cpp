// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/surface_walk.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;

constexpr float kDegrees = 57.29577951308232f;
constexpr float kWall = 2;       // times an edge's angle
constexpr float kAcross = 0.5f;  // sine between a path and a wall at which it ends
constexpr float kMostLean = 0.9999f;

Vector3f direction_of(const TriangleGraph& graph, const TriangleSide& side) {
    return unit(graph.position(side.triangle, (side.k + 1) % 3) -
                graph.position(side.triangle, side.k));
}

/// Unit, in the triangle's plane, out of it across a side.
Vector3f outwards(const TriangleGraph& graph, const TriangleSide& side) {
    return direction_of(graph, side).cross(graph.triangles[side.triangle].normal);
}

float arc_sine(float sine) {
    return float(std::asin(std::clamp(double(sine), -1., 1.)));
}

/// Whether the edge at a side, which there has to be, is bent by less.
bool is_within(const TriangleGraph& graph, const TriangleSide& side, const SmallAngle& angle) {
    const float cosine = graph.cosine_across(side.triangle, side.k);
    return cosine > angle.cosine_below ||
           (cosine >= angle.cosine_above && std::abs(signed_angle(graph, side)) < angle.degrees);
}

bool is_wall(const TriangleGraph& graph, const TriangleSide& side, const SmallAngle& least) {
    const std::uint32_t next = graph.triangles[side.triangle].neighbours[side.k];
    return next == TriangleGraph::kNone || graph.triangles[next].normal.isZero(0) ||
           !is_within(graph, side, least);
}

/// What turns so much beside an edge is no part of a face that goes on across it.
SmallAngle wall_angle(float angle) {
    return SmallAngle(std::min(kWall * std::abs(angle), kEdgeAngle));
}

/// From a side along the only other one that is a wall; zero: none is, or both.
Vector3f along_wall(const TriangleGraph& graph, const TriangleSide& side, const SmallAngle& least) {
    const TriangleSide next{side.triangle, (side.k + 1) % 3}, last{side.triangle, (side.k + 2) % 3};
    const bool is_next = is_wall(graph, next, least);
    if (is_next == is_wall(graph, last, least)) return Vector3f::Zero();
    return is_next ? direction_of(graph, next) : Vector3f(-direction_of(graph, last));
}

}  // namespace

TriangleSide side_beyond(const TriangleGraph& graph, const TriangleSide& side) {
    const std::uint32_t next = graph.triangles[side.triangle].neighbours[side.k];
    const Vector3f a = graph.position(side.triangle, side.k),
                   b = graph.position(side.triangle, (side.k + 1) % 3);
    unsigned any = 0;
    for (unsigned k = 0; k < 3; ++k) {
        if (graph.triangles[next].neighbours[k] != side.triangle) continue;
        any = k;
        const Vector3f c = graph.position(next, k), d = graph.position(next, (k + 1) % 3);
        if ((c == a && d == b) || (c == b && d == a)) return {next, k};
    }
    return {next, any};
}

float signed_angle(const TriangleGraph& graph, const TriangleSide& side) {
    const TriangleGraph::Node& node = graph.triangles[side.triangle];
    const Vector3f other =
        node.sign_across(side.k) * graph.triangles[node.neighbours[side.k]].normal;
    return arc_tangent(dot(node.normal.cross(other), direction_of(graph, side)),
                       dot(node.normal, other)) *
           kDegrees;
}

float lean_of_walls(const TriangleGraph& graph, const TriangleSide& side) {
    const TriangleSide beyond = side_beyond(graph, side);
    const Vector3f along = direction_of(graph, side);
    const SmallAngle least = wall_angle(signed_angle(graph, side));
    const Vector3f here = along_wall(graph, side, least), there = -along_wall(graph, beyond, least);
    if (here.isZero(0) || there.isZero(0)) return 0;
    const float a = arc_sine(dot(here, along)), b = arc_sine(dot(there, along));
    const float lean = std::sin((a + b) / 2);
    return std::abs(a - b) < arc_sine(kAcross) && std::abs(lean) < kMostLean ? lean : 0;
}

SmallAngle::SmallAngle(float size) : degrees(size) {
    constexpr float kRounding = 1e-6f;  // of products of unit vectors
    const float cosine = std::cos(size / kDegrees);
    cosine_below = cosine + kRounding;
    cosine_above = cosine - kRounding;
}

SurfaceWalk::SurfaceWalk(const TriangleGraph& graph, const TriangleSide& from, float lean)
    : graph_(graph),
      at_(from),
      place_((graph.position(from.triangle, from.k) +
              graph.position(from.triangle, (from.k + 1) % 3)) /
             2),
      direction_(lean * direction_of(graph, from) -
                 std::sqrt(1 - lean * lean) * outwards(graph, from)),
      tangent_of_lean_(lean / std::sqrt(1 - lean * lean)),
      wall_angle_(wall_angle(signed_angle(graph, from))) {
    cross();
}

template <class Is>
bool SurfaceWalk::has_side(const Is& is) const {
    const TriangleGraph::Node& node = graph_.triangles[at_.triangle];
    for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t next = node.neighbours[k];
        if (k == at_.k || next == TriangleGraph::kNone) continue;
        if (!graph_.triangles[next].normal.isZero(0) && is(TriangleSide{at_.triangle, k}))
            return true;
    }
    return false;
}

bool SurfaceWalk::has_side_between(float least, float most) const {
    return has_side([&](const TriangleSide& side) {
        const float angle = sign_ * signed_angle(graph_, side);
        return angle > least && angle < most;
    });
}

bool SurfaceWalk::has_side_within(const SmallAngle& angle) const {
    return has_side([&](const TriangleSide& side) { return is_within(graph_, side, angle); });
}

bool SurfaceWalk::goes_on_within(const SmallAngle& angle) const {
    return goes_on_ && graph_.cosine_across(at_.triangle, exit_) > angle.cosine_below;
}

void SurfaceWalk::cross() {
    const TriangleGraph::Node& node = graph_.triangles[at_.triangle];
    const Vector3f aside = direction_ - tangent_of_lean_ * sign_ * direction_.cross(node.normal);
    centre_ = begin_ + dot(node.centre - place_, aside);
    end_ = begin_;
    if (!find_exit(at_.k)) return;
    const unsigned wall = exit_;
    if (slant_ >= kAcross || !is_wall(graph_, {at_.triangle, wall}, wall_angle_)) return;
    direction_ = dot(direction_, along_) > 0 ? along_ : -along_;
    // the side that is left, unless the path has come from there
    if (!find_exit(wall)) goes_on_ = false;
}

bool SurfaceWalk::find_exit(unsigned wall) {
    const TriangleGraph::Node& node = graph_.triangles[at_.triangle];
    float nearest = std::numeric_limits<float>::max();
    for (unsigned k = 0; k < 3; ++k) {
        if (k == at_.k || k == wall) continue;
        const Vector3f along = direction_of(graph_, {at_.triangle, k});
        const Vector3f out = along.cross(node.normal);
        const float slant = dot(direction_, out);
        if (!(slant > 1e-6f)) continue;
        const float distance = dot(graph_.position(at_.triangle, k) - place_, out) / slant;
        if (distance >= nearest) continue;
        nearest = distance;
        exit_ = k;
        along_ = along;
        slant_ = slant;
    }
    goes_on_ = nearest < std::numeric_limits<float>::max();
    if (!goes_on_) return false;
    end_ += std::max(nearest, 0.f);
    place_ += std::max(nearest, 0.f) * direction_;
    const std::uint32_t next = node.neighbours[exit_];
    goes_on_ = next != TriangleGraph::kNone && !graph_.triangles[next].normal.isZero(0);
    return true;
}

void SurfaceWalk::go_on() {
    const TriangleSide exit{at_.triangle, exit_};
    const TriangleSide next = side_beyond(graph_, exit);
    sign_ *= graph_.triangles[at_.triangle].sign_across(exit_);
    direction_ = unit(dot(direction_, along_) * along_ - slant_ * outwards(graph_, next));
    begin_ = end_;
    at_ = next;
    cross();
}

}  // namespace laplacian_lines
