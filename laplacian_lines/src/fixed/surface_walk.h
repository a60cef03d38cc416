// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fixed/surface.h"

namespace laplacian_lines {

/// From this angle on, degrees (see kSharpCosine), edges are the form's whatever is around:
/// tessellators of curved faces stay below, with 0.6 radians (34 degrees) as the coarsest in use.
constexpr float kEdgeAngle = 40;

/// Between the normals at a side, degrees: positive where the surface is convex as the triangle
/// sees it.
float signed_angle(const Surface& surface, std::uint32_t side);

/// The sine by which a path across a side leans towards the side's end: 0, unless the triangles on
/// both sides have one boundary each. Then the face is a band between boundaries, such as a
/// chamfer, and curves along it. Boundaries are borders and edges that turn much more than the side
/// does.
float lean_of_boundaries(const Surface& surface, std::uint32_t side);

/// An angle of up to 90 degrees, for comparisons: for most edges the cosine between their normals
/// decides, without an arc tangent.
struct SmallAngle {
    explicit SmallAngle(float size);

    float degrees;
    float cosine_below, cosine_above;  ///< of angles that are certainly less, or more
};

/// A straight path on a face: from the middle of an edge over one triangle after the other. Where
/// the path meets a boundary at a slant it goes on along the boundary.
class SurfaceWalk {
public:
    /// Starts into the triangle of this side, at a right angle to it but for the sine `lean`
    /// towards the side's end.
    SurfaceWalk(const Surface& surface, std::uint32_t from, float lean);

    /// Places along the path, 0 at the edge where it began: the triangle's centre, projected along
    /// that edge, and where the path enters and leaves the triangle.
    float centre() const { return centre_; }
    float begin() const { return begin_; }
    float end() const { return end_; }
    float area() const { return surface_.facet(at_ / 3).area; }
    /// Whether the surface bends by an angle() between these at a side other than the entry.
    bool has_side_between(float least, float most) const;
    bool has_side_within(const SmallAngle& angle) const;
    /// Angle of the edge at the exit, degrees, positive where the surface is convex as the first
    /// triangle sees it; and the part of it by which the path turns, which may cross at a slant.
    float angle() const { return sign_ * signed_angle(surface_, exit_); }
    float turn() const { return angle() * sine_; }
    /// Whether the surface continues at the exit and angle() is certainly less.
    bool continues_within(const SmallAngle& angle) const;
    /// Whether the surface ends there, or the path finds no exit.
    bool is_at_border() const { return !has_next_; }

    /// Into the next triangle. Not at a border.
    void advance();

private:
    /// Whether `is` holds for a side with a neighbour other than the entry.
    template <class Is>
    bool has_side(const Is& is) const;
    void cross();
    /// Finds where the path leaves the triangle, other than by `excluded`; false if nowhere.
    bool find_exit(std::uint32_t excluded);

    const Surface& surface_;
    std::uint32_t at_;                                                     // the entry
    Eigen::Vector3f place_, direction_, along_ = Eigen::Vector3f::Zero();  // along_: of the exit
    const float tangent_of_lean_;
    const SmallAngle boundary_angle_;
    float sign_ = 1;  // -1: the triangle has the other orientation than the first one
    float begin_ = 0, centre_ = 0, end_ = 0;
    float sine_ = 0;  // between the path and the exit
    std::uint32_t exit_ = 0;
    bool has_next_ = false;
};

}  // namespace laplacian_lines
