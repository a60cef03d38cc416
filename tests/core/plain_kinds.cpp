// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_kinds.h"

#include <cmath>

#include "laplacian_lines/tangent_frame.h"

namespace reference {

using Eigen::Vector2f;
using Eigen::Vector3f;

namespace {

float dot(const Vector3f& a, const Vector3f& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}
float dot(const Vector2f& a, const Vector2f& b) {
    return a.x() * b.x() + a.y() * b.y();
}

/// In the frame of S̄ and C.
Vector2f tangent(const KindVertex& p, const Vector3f& x) {
    const auto [u, v] = laplacian_lines::tangent_frame(p.normal);
    return {dot(u, x), dot(v, x)};
}

}  // namespace

Vector2f KindVertex::S(const Vector2f& x) const {
    return {curvature[0] * x.x() + curvature[1] * x.y(),
            curvature[1] * x.x() + curvature[2] * x.y()};
}

float KindVertex::C(const Vector2f& x, const Vector2f& y, const Vector2f& z) const {
    const float uu = x.x() * y.x(), uv = x.x() * y.y() + x.y() * y.x(), vv = x.y() * y.y();
    return z.x() * (derivative[0] * uu + derivative[1] * uv + derivative[2] * vv) +
           z.y() * (derivative[1] * uu + derivative[2] * uv + derivative[3] * vv);
}

float radial(const KindVertex& p, const Vector3f& e, float w) {
    const Vector2f v = tangent(p, e - w * p.position);
    return dot(v, p.S(v));
}

float photic(const KindVertex& p, const Vector3f& e, float w) {
    const Vector3f to_light = e - p.position * w;
    const Vector2f l = tangent(p, to_light), g = p.S(l), sg = p.S(g);
    return p.C(g, g, l) - dot(p.normal, to_light) * dot(sg, sg) - w * dot(g, sg);
}

ApparentCurvature apparent_curvature(const KindVertex& p, const Vector3f& e, float w_of_eye) {
    const Vector3f to_eye = e - p.position * w_of_eye;
    const float distance = std::sqrt(dot(to_eye, to_eye)), per_distance = w_of_eye / distance;
    const Vector3f unit = to_eye * (1 / distance);
    const float cosine = dot(p.normal, unit), k = 1 / (cosine * (1 + cosine));
    if (!(cosine > 0)) return {};
    const Vector2f w = tangent(p, unit);
    const auto to_surface = [&](const Vector2f& x) -> Vector2f { return x + w * (k * dot(w, x)); };
    const float across = k * w.x() * w.y();
    const Vector2f su = p.S({1 + k * w.x() * w.x(), across}),
                   sv = p.S({across, 1 + k * w.y() * w.y()});
    const float uu = dot(su, su), uv = dot(su, sv), vv = dot(sv, sv);
    const float half = (uu - vv) / 2, root = std::sqrt(half * half + uv * uv);
    const float tu = half > 0 ? half + root : uv, tv = half > 0 ? uv : -half + root;
    const float length = std::sqrt(tu * tu + tv * tv);
    if (!(length > 0)) return {};
    const Vector2f t = {tu / length, tv / length};
    const Vector2f a = to_surface(t), b = p.S(a), r = a * (1 / std::sqrt(dot(a, a))), x = p.S(b);
    // x·(dA t) along r
    const Vector2f sr = p.S(r);
    const float wr = dot(w, r), wx = dot(w, x), wt = dot(w, t);
    const float d_cosine = dot(sr, w) + per_distance * cosine * wr;
    const Vector2f dw = (r - w * wr) * (-per_distance) - sr * cosine;
    const float change =
        k * (dot(dw, x) * wt + wx * dot(dw, t)) - k * k * (1 + 2 * cosine) * d_cosine * wx * wt;
    const float q = std::sqrt((uu + vv) / 2 + root);
    const auto [u, v] = laplacian_lines::tangent_frame(p.normal);
    return {q, (change + p.C(r, a, b)) / q, u * r.x() + v * r.y()};
}

}  // namespace reference
