// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/section_profile.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr float kDegrees = 57.29577951308232f;
constexpr std::size_t kMostSteps = 4096;  // a section may run around a form that is smaller

/// A point of the surface and its normal, of any length.
struct Place {
    Eigen::Vector3f position, normal;
};

Place between(const VertexRecord& a, const VertexRecord& b, float t) {
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

/// The plane of a section, moved and turned so little that it clearly crosses the side that it
/// begins on: not at an end of it, nor along it.
Plane crossing_plane(const SectionProbe::Section& section, const VertexRecord& a,
                     const VertexRecord& b) {
    const Place from = between(a, b, 0), to = between(a, b, 1);
    const Eigen::Vector3f edge = to.position - from.position;
    const float length = length_of(edge);
    Plane plane = {section.point, unit(section.normal.cross(section.across))};
    if (!(length > 0)) return plane;
    const float t = dot(section.point - from.position, edge) / (length * length);
    plane.origin += (std::clamp(t, 0.02f, 0.98f) - t) * edge;
    const float crossing = dot(plane.normal, edge) / length;
    if (std::abs(crossing) < 0.02f) plane.normal += (crossing < 0 ? -0.02f : 0.02f) / length * edge;
    return plane;
}

/// Where the plane leaves the triangle that it enters by a side; that side becomes the one by which
/// it leaves.
Place leave(const std::vector<PlacedCluster>& clusters, const Plane& plane, MeshSide& at) {
    const PlacedCluster& placed = clusters[at.cluster];
    const auto& corners = placed.triangle(at.triangle).corners;
    float heights[3];
    for (int k = 0; k < 3; ++k)
        heights[k] = plane.height(placed.records[corners[k]]);
    const unsigned next = (at.side + 1u) % 3, opposite = (at.side + 2u) % 3;
    const bool is_by_next = (heights[opposite] < 0) == (heights[at.side] < 0);
    const unsigned a = is_by_next ? next : opposite, b = (a + 1) % 3;
    at.side = std::uint8_t(a);
    const float fall = heights[a] - heights[b];
    const float t = fall != 0 ? std::clamp(heights[a] / fall, 0.f, 1.f) : 0.5f;
    return between(placed.records[corners[a]], placed.records[corners[b]], t);
}

}  // namespace

void SectionProbe::measure(const Section& section, float reach, SectionProfile& profile) const {
    const PlacedCluster& placed = placed_[section.side.cluster];
    const auto& corners = placed.triangle(section.side.triangle).corners;
    const Plane plane = crossing_plane(section, placed.records[corners[section.side.side]],
                                       placed.records[corners[(section.side.side + 1) % 3]]);
    MeshSide at[2] = {section.side, sides_.across(section.side)};
    Place next[2];
    float along[2] = {0, 0};
    for (int k = 0; k < 2; ++k)
        if (at[k].exists()) {
            next[k] = leave(placed_, plane, at[k]);
            along[k] = dot(next[k].position - section.point, section.across);
        }
    // Which of the two triangles is on the positive side.
    const bool is_first = along[0] > along[1];
    const Eigen::Vector3f up = unit(section.normal);
    for (int k = 0; k < 2; ++k) {
        const bool is_positive = (k == 0) == is_first;
        const Eigen::Vector3f forward = is_positive ? section.across : -section.across;
        SectionProfile::Side& side = profile.sides_[is_positive];
        side.assign(1, {0, 0, section.point});
        while (at[k].exists()) {
            const SectionProfile::Place& last = side.back();
            const float distance = last.distance + length_of(next[k].position - last.position);
            const float angle = sign_ *
                                arc_tangent(dot(next[k].normal, forward), dot(next[k].normal, up)) *
                                kDegrees;
            side.push_back({distance, angle, next[k].position});
            if (distance >= reach || side.size() > kMostSteps) break;
            at[k] = sides_.across(at[k]);
            if (at[k].exists()) next[k] = leave(placed_, plane, at[k]);
        }
    }
}

namespace {

/// Calls read(a, b, t) with the neighbours of a place among others and its share of the distance
/// between them.
template <class Side, class Read>
auto interpolate(const Side& side, float distance, Read read) {
    const auto after =
        std::lower_bound(side.begin(), side.end(), distance,
                         [](const auto& place, float d) { return place.distance < d; });
    if (after == side.begin()) return read(*after, *after, 0.f);
    if (after == side.end()) return read(side.back(), side.back(), 0.f);
    const auto &a = *(after - 1), &b = *after;
    return read(a, b, (distance - a.distance) / (b.distance - a.distance));
}

}  // namespace

float SectionProfile::angle(float distance) const {
    const float angle = interpolate(
        side(distance), std::abs(distance),
        [](const Place& a, const Place& b, float t) { return (1 - t) * a.angle + t * b.angle; });
    return distance < 0 ? -angle : angle;
}

Eigen::Vector3f SectionProfile::position(float distance) const {
    return interpolate(side(distance), std::abs(distance),
                       [](const Place& a, const Place& b, float t) -> Eigen::Vector3f {
                           return (1 - t) * a.position + t * b.position;
                       });
}

float SectionProfile::middle(float reach) const {
    const float half = (angle(reach) + angle(-reach)) / 2;
    float low = -reach, high = reach;
    for (int step = 0; step < 10; ++step) {
        const float mid = (low + high) / 2;
        (angle(mid) < half ? low : high) = mid;
    }
    return (low + high) / 2;
}

}  // namespace laplacian_lines
