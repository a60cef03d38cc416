// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fixed/triangle_graph.h"

namespace laplacian_lines {

/// Side k of a triangle.
struct TriangleSide {
    std::uint32_t triangle;
    unsigned k;
};

/// The same edge as a side of the triangle beyond, which there has to be.
TriangleSide side_beyond(const TriangleGraph& graph, const TriangleSide& side);

/// Between the normals at a side, degrees: positive where the surface is convex as the triangle
/// sees it.
float signed_angle(const TriangleGraph& graph, const TriangleSide& side);

/// A straight path over the surface: from the middle of an edge at a right angle to it, over one
/// triangle after the other.
class SurfaceWalk {
public:
    /// Into the triangle of this side.
    SurfaceWalk(const TriangleGraph& graph, const TriangleSide& from);

    /// Where the triangle's centre is along the path, and where it enters and leaves the
    /// triangle; the edge that it began at is at 0.
    float centre() const { return centre_; }
    float begin() const { return begin_; }
    float end() const { return end_; }
    float area() const { return graph_.triangles[at_.triangle].area; }
    /// Whether the surface goes on beyond another side than the one it came in by, bent by
    /// less than `most` degrees.
    bool goes_on_flat(float most) const;
    /// By how much the edge there is bent, degrees, positive where the surface is convex as the
    /// first triangle sees it; and how much of it the path turns, as it may cross at a slant.
    float angle() const { return angle_; }
    float turn() const { return angle_ * slant_; }
    /// 1 where the path crosses that edge at a right angle, towards 0 along it.
    float slant() const { return slant_; }
    /// Whether the surface ends there.
    bool is_at_border() const { return !goes_on_; }

    /// On into the next triangle, unless the surface ends.
    void go_on();

private:
    void cross();

    const TriangleGraph& graph_;
    TriangleSide at_;  // the triangle, and the side it came in by
    Eigen::Vector3f place_, direction_, out_ = Eigen::Vector3f::Zero();
    float sign_ = 1;  // -1: the triangle has the other orientation than the first one
    float begin_ = 0, centre_ = 0, end_ = 0, angle_ = 0, slant_ = 0;
    unsigned exit_ = 0;
    bool goes_on_ = false;
};

}  // namespace laplacian_lines
