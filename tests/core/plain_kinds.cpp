// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_kinds.h"

#include <cmath>

#include "laplacian_lines/tangent_frame.h"

namespace reference {

using Eigen::Vector3f;

namespace {

float dot(const Vector3f& a, const Vector3f& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

}  // namespace

float KindVertex::C(const Vector3f& x, const Vector3f& y, const Vector3f& z) const {
    const auto [u, v] = laplacian_lines::tangent_frame(normal);
    const float xu = dot(u, x), xv = dot(v, x), yu = dot(u, y), yv = dot(v, y);
    const float uu = xu * yu, uv = xu * yv + xv * yu, vv = xv * yv;
    return dot(u, z) * (derivative[0] * uu + derivative[1] * uv + derivative[2] * vv) +
           dot(v, z) * (derivative[1] * uu + derivative[2] * uv + derivative[3] * vv);
}

Vector3f KindVertex::S(const Vector3f& x) const {
    const auto& s = shape_operator;
    return {dot({s.xx, s.xy, s.xz}, x), dot({s.xy, s.yy, s.yz}, x), dot({s.xz, s.yz, s.zz}, x)};
}

float radial(const KindVertex& p, const Vector3f& e, float w) {
    const Vector3f v = e - w * p.position;
    return dot(v, p.S(v));
}

float photic(const KindVertex& p, const Vector3f& e, float w) {
    const Vector3f l = e - p.position * w, g = p.S(l), sg = p.S(g);
    return p.C(g, g, l) - dot(p.normal, l) * dot(sg, sg) - w * dot(g, sg);
}

ApparentCurvature apparent_curvature(const KindVertex& p, const Vector3f& e, float w_of_eye) {
    const Vector3f v = e - p.position * w_of_eye;
    const float distance = std::sqrt(dot(v, v)), per_distance = w_of_eye / distance;
    const Vector3f unit = v * (1 / distance);
    const float cosine = dot(p.normal, unit), k = 1 / (cosine * (1 + cosine));
    if (!(cosine > 0)) return {};
    const Vector3f w = unit - p.normal * cosine;
    const auto to_surface = [&](const Vector3f& x) -> Vector3f { return x + w * (k * dot(w, x)); };
    const auto [u, side] = laplacian_lines::tangent_frame(p.normal);
    const Vector3f su = p.S(to_surface(u)), sv = p.S(to_surface(side));
    const float uu = dot(su, su), uv = dot(su, sv), vv = dot(sv, sv);
    const float half = (uu - vv) / 2, root = std::sqrt(half * half + uv * uv);
    const float tu = half > 0 ? half + root : uv, tv = half > 0 ? uv : -half + root;
    const float length = std::sqrt(tu * tu + tv * tv);
    if (!(length > 0)) return {};
    const Vector3f t = u * (tu / length) + side * (tv / length);
    const Vector3f a = to_surface(t), b = p.S(a), r = a * (1 / std::sqrt(dot(a, a))), x = p.S(b);
    // x·(dA t) along r
    const Vector3f sr = p.S(r);
    const float wr = dot(w, r), wx = dot(w, x), wt = dot(w, t);
    const float d_cosine = dot(sr, w) + per_distance * cosine * wr;
    const Vector3f dw = (r - w * wr) * (-per_distance) - sr * cosine;
    const float change =
        k * (dot(dw, x) * wt + wx * dot(dw, t)) - k * k * (1 + 2 * cosine) * d_cosine * wx * wt;
    const float q = std::sqrt((uu + vv) / 2 + root);
    return {q, (change + p.C(r, a, b)) / q, r};
}

}  // namespace reference
