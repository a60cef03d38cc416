// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/crease_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;

constexpr float kDegrees = 57.29577951308232f;
constexpr float kNotch = 2;  // how much more the other diagonal of an edge of the form bends

float bend(const Vector3f& a, const Vector3f& b, float length) {
    if (b.isZero(0)) return 0;
    return arc_tangent(length_of(a.cross(b)), dot(a, b)) * length;
}

/// Two triangles p, q, r and q, p, s with the four around them.
struct Quad {
    Vector3f p, q, r, s;
    Vector3f upper, lower;  // normals of the triangles, as the first one's
    Vector3f around[4];     // normals beyond qr, rp, ps, sq; zero: none

    bool goes_on_flat(const Vector3f& normal, const Vector3f& beyond) const {
        return !beyond.isZero(0) && bend(normal, beyond, kDegrees) < kFlat;
    }
    /// Whether both triangles are parts of larger flat faces, which the other diagonal would cut.
    bool parts_faces() const {
        return (goes_on_flat(upper, around[0]) || goes_on_flat(upper, around[1])) &&
               (goes_on_flat(lower, around[2]) || goes_on_flat(lower, around[3]));
    }
};

Vector3f normal_of(const Vector3f& a, const Vector3f& b, const Vector3f& c) {
    const Vector3f area = (b - a).cross(c - a);
    const float most = area.cwiseAbs().maxCoeff();
    return most > 0 ? unit(area / most) : area;
}

Vector3f normal_beyond(const TriangleGraph& graph, const TriangleSide& side, float sign) {
    const TriangleGraph::Node& node = graph.triangles[side.triangle];
    const std::uint32_t next = node.neighbours[side.k];
    if (next == TriangleGraph::kNone) return Vector3f::Zero();
    return sign * node.sign_across(side.k) * graph.triangles[next].normal;
}

float cosine_of_edges() {
    static const float cosine = std::cos(kEdgeAngle / kDegrees);
    return cosine;
}

Quad quad_at(const TriangleGraph& graph, const TriangleSide& side) {
    const auto [a, k] = side;
    const auto [b, l] = side_beyond(graph, side);
    const float sign = graph.triangles[a].sign_across(k);
    Quad quad{graph.position(a, k),
              graph.position(a, (k + 1) % 3),
              graph.position(a, (k + 2) % 3),
              graph.position(b, (l + 2) % 3),
              graph.triangles[a].normal,
              sign * graph.triangles[b].normal,
              {}};
    quad.around[0] = normal_beyond(graph, {a, (k + 1) % 3}, 1);
    quad.around[1] = normal_beyond(graph, {a, (k + 2) % 3}, 1);
    const bool from_q = graph.position(b, l) == quad.q;  // as triangles of one orientation have it
    quad.around[2] = normal_beyond(graph, {b, (l + (from_q ? 1 : 2)) % 3}, sign);
    quad.around[3] = normal_beyond(graph, {b, (l + (from_q ? 2 : 1)) % 3}, sign);
    for (int i = 0; i < 4; ++i)  // edges of the form are no matter of diagonals
        if (dot(i < 2 ? quad.upper : quad.lower, quad.around[i]) < cosine_of_edges())
            quad.around[i].setZero();
    return quad;
}

/// The sides qr, rp, ps, sq with the triangles that are at them.
float bend_around(const Quad& quad, const Vector3f* const (&normals)[4]) {
    const float lengths[4] = {length_of(quad.q - quad.r), length_of(quad.r - quad.p),
                              length_of(quad.p - quad.s), length_of(quad.s - quad.q)};
    float sum = 0;
    for (int i = 0; i < 4; ++i)
        sum += bend(*normals[i], quad.around[i], lengths[i]);
    return sum;
}

}  // namespace

bool is_mere_diagonal(const TriangleGraph& graph, const TriangleSide& side) {
    const Quad quad = quad_at(graph, side);
    if (quad.parts_faces()) return false;
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
