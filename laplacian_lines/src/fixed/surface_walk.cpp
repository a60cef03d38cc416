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

constexpr float kBoundary = 2;        // times the tested edge's angle
constexpr float kAcross = 0.5f;       // least sine between a path and a boundary at which it ends
constexpr float kMostLean = 0.9999f;  // beyond it boundaries run along the side

Vector3f direction_of(const Surface& surface, std::uint32_t side) {
    return unit(surface.span(side));
}

/// Unit, in the triangle's plane, outwards across a side.
Vector3f outwards(const Surface& surface, std::uint32_t side) {
    return direction_of(surface, side).cross(surface.facet(side / 3).normal);
}

/// Whether the surface bends by less at a side with a neighbour.
bool is_within(const Surface& surface, std::uint32_t side, const SmallAngle& angle) {
    const float cosine = surface.cosine_across(side);
    return cosine > angle.cosine_below ||
           (cosine >= angle.cosine_above && std::abs(signed_angle(surface, side)) < angle.degrees);
}

bool is_boundary(const Surface& surface, std::uint32_t side, const SmallAngle& least) {
    return !surface.has_neighbour(side) || !is_within(surface, side, least);
}

/// Edges from this angle on bound the faces on both sides of the tested edge.
SmallAngle boundary_angle(float angle) {
    return SmallAngle(std::min(kBoundary * std::abs(angle), kEdgeAngle));
}

/// The direction, away from a side, of the one other side that is a boundary; zero if none or both
/// are.
Vector3f along_boundary(const Surface& surface, std::uint32_t side, const SmallAngle& least) {
    const std::uint32_t next = next_side(side), previous = previous_side(side);
    const bool is_next = is_boundary(surface, next, least);
    if (is_next == is_boundary(surface, previous, least)) return Vector3f::Zero();
    return is_next ? direction_of(surface, next) : Vector3f(-direction_of(surface, previous));
}

}  // namespace

float signed_angle(const Surface& surface, std::uint32_t side) {
    const Vector3f& normal = surface.facet(side / 3).normal;
    const Vector3f other = surface.sign_across(side) * surface.beyond(side).normal;
    return arc_tangent(dot(normal.cross(other), direction_of(surface, side)), dot(normal, other)) *
           kDegrees;
}

float lean_of_boundaries(const Surface& surface, std::uint32_t side) {
    const Vector3f along = direction_of(surface, side);
    const SmallAngle least = boundary_angle(signed_angle(surface, side));
    const Vector3f here = along_boundary(surface, side, least),
                   there = -along_boundary(surface, surface.across(side), least);
    if (here.isZero(0) || there.isZero(0)) return 0;
    const float lean = dot(here + there, along) / 2;
    return std::abs(lean) < kMostLean ? lean : 0;
}

SmallAngle::SmallAngle(float size) : degrees(size) {
    constexpr float kRounding = 1e-6f;  // of products of unit vectors
    const float cosine = cosine_of(size / kDegrees);
    cosine_below = cosine + kRounding;
    cosine_above = cosine - kRounding;
}

SurfaceWalk::SurfaceWalk(const Surface& surface, std::uint32_t from, float lean)
    : surface_(surface),
      at_(from),
      place_((surface.position(surface.begin(from)) + surface.position(surface.end(from))) / 2),
      direction_(lean * direction_of(surface, from) -
                 std::sqrt(1 - lean * lean) * outwards(surface, from)),
      tangent_of_lean_(lean / std::sqrt(1 - lean * lean)),
      boundary_angle_(boundary_angle(signed_angle(surface, from))) {
    cross();
}

template <class Is>
bool SurfaceWalk::has_side(const Is& is) const {
    for (const std::uint32_t side : {next_side(at_), previous_side(at_)})
        if (surface_.has_neighbour(side) && is(side)) return true;
    return false;
}

bool SurfaceWalk::has_side_between(float least, float most) const {
    return has_side([&](std::uint32_t side) {
        const float angle = sign_ * signed_angle(surface_, side);
        return angle > least && angle < most;
    });
}

bool SurfaceWalk::has_side_within(const SmallAngle& angle) const {
    return has_side([&](std::uint32_t side) { return is_within(surface_, side, angle); });
}

bool SurfaceWalk::continues_within(const SmallAngle& angle) const {
    return has_next_ && surface_.cosine_across(exit_) > angle.cosine_below;
}

void SurfaceWalk::cross() {
    const Surface::Facet& facet = surface_.facet(at_ / 3);
    const Vector3f aside = direction_ - tangent_of_lean_ * sign_ * direction_.cross(facet.normal);
    centre_ = begin_ + dot(facet.centre - place_, aside);
    end_ = begin_;
    if (!find_exit(at_)) return;
    const std::uint32_t boundary = exit_;
    if (sine_ >= kAcross || !is_boundary(surface_, boundary, boundary_angle_)) return;
    direction_ = dot(direction_, along_) > 0 ? along_ : -along_;
    find_exit(boundary);  // the third side, unless the boundary leads back to the entry
}

bool SurfaceWalk::find_exit(std::uint32_t excluded) {
    float nearest = std::numeric_limits<float>::max();
    for (const std::uint32_t side : {next_side(at_), previous_side(at_)}) {
        if (side == excluded) continue;
        const Vector3f along = direction_of(surface_, side);
        const Vector3f out = along.cross(surface_.facet(at_ / 3).normal);
        const float sine = dot(direction_, out);
        if (!(sine > 1e-6f)) continue;  // along the side, or away from it
        const float distance = dot(surface_.position(surface_.begin(side)) - place_, out) / sine;
        if (distance >= nearest) continue;
        nearest = distance;
        exit_ = side;
        along_ = along;
        sine_ = sine;
    }
    has_next_ = nearest < std::numeric_limits<float>::max();
    if (!has_next_) return false;
    end_ += std::max(nearest, 0.f);
    place_ += std::max(nearest, 0.f) * direction_;
    has_next_ = surface_.has_neighbour(exit_);
    return true;
}

void SurfaceWalk::advance() {
    const std::uint32_t next = surface_.across(exit_);
    sign_ *= surface_.sign_across(exit_);
    direction_ = unit(dot(direction_, along_) * along_ - sine_ * outwards(surface_, next));
    begin_ = end_;
    at_ = next;
    cross();
}

}  // namespace laplacian_lines
