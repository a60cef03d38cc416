// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "fixed/surface.h"

namespace laplacian_lines {

/// Edges of so many degrees are edges of the form whatever is around: tessellators of curved faces
/// stay below, with 0.6 radians (34 degrees) as the coarsest tolerance in use.
constexpr float kEdgeAngle = 40;

/// Between the normals at a side, degrees: positive where the surface is convex as the triangle
/// sees it.
float signed_angle(const Surface& surface, std::uint32_t side);

/// The sine by which a path across a side leans towards the side's end: 0, unless the triangles on
/// both sides have one wall each and these go the same way. Then the face is a band between walls,
/// such as a chamfer, and turns along it. Walls are borders and edges that turn much more than the
/// side does.
float lean_of_walls(const Surface& surface, std::uint32_t side);

/// An angle of up to 90 degrees, for comparing with. Of most edges the cosine between their normals
/// tells, which is had without an arc tangent.
struct SmallAngle {
    explicit SmallAngle(float size);

    float degrees;
    float cosine_below, cosine_above;  ///< of what is less, and more, for certain
};

/// A straight path on a face: from the middle of an edge over one triangle after the other. Where
/// it meets a wall at a slant it goes on along it.
class SurfaceWalk {
public:
    /// Into the triangle of this side, leaning by this sine from the right angle towards the side's
    /// end.
    SurfaceWalk(const Surface& surface, std::uint32_t from, float lean);

    /// Where the triangle's centre is along the path, as seen in the direction of the edge that it
    /// began at, and where it enters and leaves the triangle; that edge is at 0.
    float centre() const { return centre_; }
    float begin() const { return begin_; }
    float end() const { return end_; }
    float area() const { return surface_.facet(at_ / 3).area; }
    /// Whether the surface goes on beyond another side than the one it came in by, bent by an
    /// angle() between these.
    bool has_side_between(float least, float most) const;
    bool has_side_within(const SmallAngle& angle) const;
    /// By how much the edge there is bent, degrees, positive where the surface is convex as the
    /// first triangle sees it; and how much of it the path turns, as it may cross at a slant.
    float angle() const { return sign_ * signed_angle(surface_, exit_); }
    float turn() const { return angle() * slant_; }
    /// Whether the surface goes on there and angle() is less for certain.
    bool goes_on_within(const SmallAngle& angle) const;
    /// Whether the surface ends there.
    bool is_at_border() const { return !goes_on_; }

    /// On into the next triangle, unless the surface ends.
    void go_on();

private:
    /// Whether another side than the one it came in by, beyond which the surface goes on, is so.
    template <class Is>
    bool has_side(const Is& is) const;
    void cross();
    bool find_exit(std::uint32_t wall);

    const Surface& surface_;
    std::uint32_t at_;                                                     // the side it came in by
    Eigen::Vector3f place_, direction_, along_ = Eigen::Vector3f::Zero();  // the exit's side
    const float tangent_of_lean_;
    const SmallAngle wall_angle_;
    float sign_ = 1;  // -1: the triangle has the other orientation than the first one
    float begin_ = 0, centre_ = 0, end_ = 0, slant_ = 0;
    std::uint32_t exit_ = 0;
    bool goes_on_ = false;
};

}  // namespace laplacian_lines
