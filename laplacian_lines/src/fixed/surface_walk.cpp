// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/surface_walk.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;

constexpr float kDegrees = 57.29577951308232f;

Vector3f direction_of(const TriangleGraph& graph, const TriangleSide& side) {
    return (graph.position(side.triangle, (side.k + 1) % 3) - graph.position(side.triangle, side.k))
        .normalized();
}

/// Unit, in the triangle's plane, out of it across a side.
Vector3f outwards(const TriangleGraph& graph, const TriangleSide& side) {
    return direction_of(graph, side).cross(graph.triangles[side.triangle].normal);
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
    return std::atan2(node.normal.cross(other).dot(direction_of(graph, side)),
                      node.normal.dot(other)) *
           kDegrees;
}

SurfaceWalk::SurfaceWalk(const TriangleGraph& graph, const TriangleSide& from)
    : graph_(graph),
      at_(from),
      place_((graph.position(from.triangle, from.k) +
              graph.position(from.triangle, (from.k + 1) % 3)) /
             2),
      direction_(-outwards(graph, from)) {
    cross();
}

bool SurfaceWalk::goes_on_flat(float most) const {
    const TriangleGraph::Node& node = graph_.triangles[at_.triangle];
    for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t next = node.neighbours[k];
        if (k == at_.k || next == TriangleGraph::kNone) continue;
        if (!graph_.triangles[next].normal.isZero(0) &&
            std::abs(signed_angle(graph_, {at_.triangle, k})) < most)
            return true;
    }
    return false;
}

void SurfaceWalk::cross() {
    const TriangleGraph::Node& node = graph_.triangles[at_.triangle];
    float nearest = std::numeric_limits<float>::max();
    for (unsigned k = 0; k < 3; ++k) {
        if (k == at_.k) continue;
        const Vector3f out = outwards(graph_, {at_.triangle, k});
        const float slant = direction_.dot(out);
        if (!(slant > 1e-6f)) continue;
        const float distance = (graph_.position(at_.triangle, k) - place_).dot(out) / slant;
        if (distance >= nearest) continue;
        nearest = distance;
        exit_ = k;
        out_ = out;
        slant_ = slant;
    }
    centre_ = begin_ + (node.centre - place_).dot(direction_);
    goes_on_ = nearest < std::numeric_limits<float>::max();
    if (!goes_on_) return;
    end_ = begin_ + std::max(nearest, 0.f);
    place_ += (end_ - begin_) * direction_;
    const std::uint32_t next = node.neighbours[exit_];
    goes_on_ = next != TriangleGraph::kNone && !graph_.triangles[next].normal.isZero(0);
    angle_ = goes_on_ ? sign_ * signed_angle(graph_, {at_.triangle, exit_}) : 0;
}

void SurfaceWalk::go_on() {
    const TriangleSide exit{at_.triangle, exit_};
    const Vector3f along = direction_of(graph_, exit);
    const TriangleSide next = side_beyond(graph_, exit);
    sign_ *= graph_.triangles[at_.triangle].sign_across(exit_);
    direction_ = (direction_.dot(along) * along - slant_ * outwards(graph_, next)).normalized();
    begin_ = end_;
    at_ = next;
    cross();
}

}  // namespace laplacian_lines
