// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/crease_edges.h"

#include <Eigen/Geometry>

#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;

constexpr float kNotch = 2;  // least factor by which the notch in an edge of the form bends more

/// Of an edge between triangles of these normals: degrees times its length, 0 at a border.
float bend(const Vector3f& a, const Vector3f& b, float length) {
    return b.isZero(0) ? 0 : degrees_between(a, b) * length;
}

/// Two triangles p, q, r and q, p, s with the four around them.
struct Quad {
    Vector3f p, q, r, s;
    Vector3f upper, lower;  // normals of the triangles, oriented like the first
    Vector3f around[4];     // normals beyond qr, rp, ps, sq; zero: none

    /// Whether both triangles are parts of larger flat faces, which the other diagonal would cut.
    bool splits_faces() const {
        const auto is_flat = [](const Vector3f& normal, const Vector3f& beyond) {
            return !beyond.isZero(0) && degrees_between(normal, beyond) < kFlat;
        };
        return (is_flat(upper, around[0]) || is_flat(upper, around[1])) &&
               (is_flat(lower, around[2]) || is_flat(lower, around[3]));
    }
};

Vector3f normal_of(const Vector3f& a, const Vector3f& b, const Vector3f& c) {
    const Vector3f area = (b - a).cross(c - a);
    const float most = area.cwiseAbs().maxCoeff();
    return most > 0 ? unit(area / most) : area;  // squares of small areas would be 0
}

/// Zero at borders.
Vector3f normal_beyond(const Surface& surface, std::uint32_t side, float sign) {
    if (!surface.has_neighbour(side)) return Vector3f::Zero();
    return sign * surface.sign_across(side) * surface.beyond(side).normal;
}

Quad quad_at(const Surface& surface, std::uint32_t side) {
    const std::uint32_t other = surface.across(side);
    const float sign = surface.sign_across(side);
    // of triangles of one orientation, one side of the edge goes from p to q, the other from q to p
    const std::uint32_t at_p = sign > 0 ? next_side(other) : previous_side(other),
                        at_q = sign > 0 ? previous_side(other) : next_side(other);
    return {
        surface.position(surface.begin(side)),
        surface.position(surface.end(side)),
        surface.position(surface.opposite(side)),
        surface.position(surface.opposite(other)),
        surface.facet(side / 3).normal,
        sign * surface.beyond(side).normal,
        {normal_beyond(surface, next_side(side), 1), normal_beyond(surface, previous_side(side), 1),
         normal_beyond(surface, at_p, sign), normal_beyond(surface, at_q, sign)}};
}

/// The bend across the sides qr, rp, ps, sq, given the normal of the triangle at each.
float bend_around(const Quad& quad, const Vector3f* const (&normals)[4]) {
    const float lengths[4] = {length_of(quad.q - quad.r), length_of(quad.r - quad.p),
                              length_of(quad.p - quad.s), length_of(quad.s - quad.q)};
    float sum = 0;
    for (int i = 0; i < 4; ++i)
        sum += bend(*normals[i], quad.around[i], lengths[i]);
    return sum;
}

}  // namespace

bool is_mere_diagonal(const Surface& surface, std::uint32_t side) {
    const Quad quad = quad_at(surface, side);
    if (quad.splits_faces()) return false;
    const Vector3f left = normal_of(quad.p, quad.s, quad.r),
                   right = normal_of(quad.s, quad.q, quad.r);
    for (const Vector3f* old : {&quad.upper, &quad.lower})
        if (!(dot(left, *old) > 0) || !(dot(right, *old) > 0)) return false;  // no quad to cut
    const float now = bend(quad.upper, quad.lower, length_of(quad.p - quad.q)) +
                      bend_around(quad, {&quad.upper, &quad.upper, &quad.lower, &quad.lower});
    const float then = bend(left, right, length_of(quad.r - quad.s)) +
                       bend_around(quad, {&right, &left, &left, &right});
    return then <= kNotch * now;
}

}  // namespace laplacian_lines
