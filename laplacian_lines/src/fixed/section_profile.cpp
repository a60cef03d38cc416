// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/section_profile.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fixed/surface_walk.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr float kDegrees = 57.29577951308232f;
constexpr std::size_t kMostSteps = 4096;  // a section may run around a form that is smaller

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

/// The plane of a section, moved and turned so little that it clearly crosses the side that it
/// begins on: not at an end of it, nor along it.
Plane crossing_plane(const Section& section, const VertexRecord& a, const VertexRecord& b) {
    const SurfacePoint from = between(a, b, 0), to = between(a, b, 1);
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

constexpr TriangleSide kNoSide{TriangleGraph::kNone, 0};

bool exists(const TriangleSide& side) {
    return side.triangle != TriangleGraph::kNone;
}

const VertexRecord& record_at(const TriangleGraph& graph, const TriangleSide& side, unsigned next) {
    return graph.records[graph.triangles[side.triangle].corners[(side.k + next) % 3]];
}

/// The side of the triangle beyond, if that has the same orientation.
TriangleSide beyond(const TriangleGraph& graph, const TriangleSide& side) {
    const TriangleGraph::Node& node = graph.triangles[side.triangle];
    const bool goes_on =
        node.neighbours[side.k] != TriangleGraph::kNone && node.sign_across(side.k) > 0;
    return goes_on ? side_beyond(graph, side) : kNoSide;
}

/// Where the plane leaves the triangle that it enters by a side; that side becomes the one by which
/// it leaves.
SurfacePoint leave(const TriangleGraph& graph, const Plane& plane, TriangleSide& at) {
    const auto height = [&](unsigned next) { return plane.height(record_at(graph, at, next)); };
    const bool is_by_next = (height(2) < 0) == (height(0) < 0);
    at.k = (at.k + (is_by_next ? 1 : 2)) % 3;
    const float begin = height(0), fall = begin - height(1);
    const float t = fall != 0 ? std::clamp(begin / fall, 0.f, 1.f) : 0.5f;
    return between(record_at(graph, at, 0), record_at(graph, at, 1), t);
}

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

void SectionProfile::measure(const TriangleGraph& graph, const Section& section, float sign,
                             float reach) {
    const Plane plane = crossing_plane(section, record_at(graph, section.side, 0),
                                       record_at(graph, section.side, 1));
    TriangleSide at[2] = {section.side, beyond(graph, section.side)};
    SurfacePoint next[2];
    float along[2] = {0, 0};
    for (int k = 0; k < 2; ++k)
        if (exists(at[k])) {
            next[k] = leave(graph, plane, at[k]);
            along[k] = dot(next[k].position - section.point, section.across);
        }
    // Which of the two triangles is on the positive side.
    const bool is_first = along[0] > along[1];
    const Eigen::Vector3f up = unit(section.normal);
    for (int k = 0; k < 2; ++k) {
        const bool is_positive = (k == 0) == is_first;
        const Eigen::Vector3f forward = is_positive ? section.across : -section.across;
        Side& side = sides_[is_positive];
        side.assign(1, {0, 0, section.point});
        while (exists(at[k])) {
            const Place& last = side.back();
            const float distance = last.distance + length_of(next[k].position - last.position);
            const float angle = sign *
                                arc_tangent(dot(next[k].normal, forward), dot(next[k].normal, up)) *
                                kDegrees;
            side.push_back({distance, angle, next[k].position});
            if (distance >= reach || side.size() > kMostSteps) break;
            at[k] = beyond(graph, at[k]);
            if (exists(at[k])) next[k] = leave(graph, plane, at[k]);
        }
    }
}

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
