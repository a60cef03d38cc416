// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/section_profile.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr std::size_t kMostSteps = 4096;  // to one side, around and around a thin form

/// A point of the surface and its normal, of any length.
struct SurfacePoint {
    Eigen::Vector3f position, normal;
};

SurfacePoint between(const VertexRecord& a, const VertexRecord& b, float t) {
    return {(1 - t) * position_of(a) + t * position_of(b),
            (1 - t) * normal_of(a) + t * normal_of(b)};
}

/// The plane of a section.
struct Plane {
    Eigen::Vector3f origin, normal;

    float height(const VertexRecord& record) const {
        return dot(normal, position_of(record) - origin);
    }
};

/// The plane of a section, which starts on the side from a to b: moved and turned, if need be, so
/// that it crosses the side 2 % of its length or more from the ends, at a sine of about .02 or
/// more.
Plane crossing_plane(const Section& section, const VertexRecord& a, const VertexRecord& b) {
    const Eigen::Vector3f edge = position_of(b) - position_of(a);
    const float length = length_of(edge);
    Plane plane = {section.point, unit(section.normal.cross(section.across))};
    if (!(length > 0)) return plane;
    const float t = dot(section.point - position_of(a), edge) / (length * length);
    plane.origin += (std::clamp(t, 0.02f, 0.98f) - t) * edge;
    const float crossing = dot(plane.normal, edge) / length;
    if (std::abs(crossing) < 0.02f) plane.normal += (crossing < 0 ? -0.02f : 0.02f) / length * edge;
    return plane;
}

constexpr std::uint32_t kNoSide = 0xffffffffu;

/// The side of the triangle beyond, if that has the same orientation.
std::uint32_t beyond(const Surface& surface, std::uint32_t side) {
    return surface.sides().has_neighbour(side) && surface.sign_across(side) > 0
               ? surface.across(side)
               : kNoSide;
}

/// Where the plane leaves the triangle that it enters by the side `at`, which becomes the side by
/// which it leaves.
SurfacePoint leave(const Surface& surface, const Plane& plane, std::uint32_t& at) {
    const auto height = [&](std::uint32_t v) { return plane.height(surface.record(v)); };
    const bool is_by_next = (height(surface.opposite(at)) < 0) == (height(surface.begin(at)) < 0);
    at = is_by_next ? next_side(at) : previous_side(at);
    const float begin = height(surface.begin(at)), fall = begin - height(surface.end(at));
    const float t = fall != 0 ? std::clamp(begin / fall, 0.f, 1.f) : 0.5f;
    return between(surface.record(surface.begin(at)), surface.record(surface.end(at)), t);
}

}  // namespace

void SectionProfile::measure(const Surface& surface, const Section& section, float sign,
                             float reach) {
    const Plane plane = crossing_plane(section, surface.record(surface.begin(section.side)),
                                       surface.record(surface.end(section.side)));
    std::uint32_t at[2] = {section.side, beyond(surface, section.side)};
    SurfacePoint next[2];
    float along[2] = {0, 0};
    for (int k = 0; k < 2; ++k)
        if (at[k] != kNoSide) {
            next[k] = leave(surface, plane, at[k]);
            along[k] = dot(next[k].position - section.point, section.across);
        }
    const Eigen::Vector3f up = unit(section.normal);
    places_.clear();
    for (const float sign_of_side : {-1.f, 1.f}) {
        const int k =
            (sign_of_side > 0) == (along[0] > along[1]) ? 0 : 1;  // the triangle on this side
        const std::size_t most = places_.size() + kMostSteps;
        if (sign_of_side > 0) {
            std::reverse(places_.begin(), places_.end());
            places_.push_back({0, 0});
        }
        Place last = {0, 0};
        Eigen::Vector3f position = section.point;
        while (at[k] != kNoSide && std::abs(last.distance) < reach && places_.size() < most) {
            last.distance += sign_of_side * length_of(next[k].position - position);
            const float angle =
                sign * kDegrees *
                arc_tangent(dot(next[k].normal, section.across), dot(next[k].normal, up));
            last.angle = angle + 360 * std::round((last.angle - angle) / 360);
            position = next[k].position;
            places_.push_back(last);
            at[k] = beyond(surface, at[k]);
            if (at[k] != kNoSide) next[k] = leave(surface, plane, at[k]);
        }
    }
}

float SectionProfile::largest_turn(float distance) const {
    const float side = distance < 0 ? -1.f : 1.f;
    float largest = std::max(0.f, side * angle(distance));
    for (const Place& place : places_)
        if (side * place.distance > 0 && side * place.distance < side * distance)
            largest = std::max(largest, side * place.angle);
    return largest;
}

float SectionProfile::angle(float distance) const {
    const auto after =
        std::lower_bound(places_.begin(), places_.end(), distance,
                         [](const Place& place, float d) { return place.distance < d; });
    if (after == places_.begin()) return after->angle;
    if (after == places_.end()) return places_.back().angle;
    const Place &a = *(after - 1), &b = *after;
    const float t = (distance - a.distance) / (b.distance - a.distance);
    return (1 - t) * a.angle + t * b.angle;
}

}  // namespace laplacian_lines
