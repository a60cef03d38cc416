// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/ridge_candidates.h"

#include <Eigen/Geometry>
#include <cmath>

#include "fixed/strong_lines.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr float kDominance = 2;       // least k₁/|k₂|
constexpr float kLeastCurvature = 4;  // 1/D; smaller ones are those of the whole form

/// The largest curvature at a vertex.
struct Bend {
    Eigen::Vector3f direction = Eigen::Vector3f::Zero();  ///< e₁, unit, of either sign
    float curvature = 0;                                  ///< k₁; 0: no candidate
    float derivative = 0;                                 ///< ∇(tr S)·e₁
};

/// `laplacian`: Δn·D²
Bend bend(const VertexRecord& record, const Eigen::Vector3f& laplacian, float sign) {
    const Eigen::Matrix3f s =
        sign * Eigen::Map<const Eigen::Matrix<float, 4, 3>>(record.shape_operator[0]).topRows<3>();
    const Eigen::Vector3f u = normal_of(record).unitOrthogonal();
    const Eigen::Vector3f v = normal_of(record).cross(u);
    const auto times = [&s](const Eigen::Vector3f& x) -> Eigen::Vector3f {
        return s.col(0) * x.x() + (s.col(1) * x.y() + s.col(2) * x.z());  // order as in dot()
    };
    const Eigen::Vector3f su = times(u), sv = times(v);
    // In the tangent plane's basis (u, v): the mean of the diagonal and what differs from it.
    const float mean = (dot(u, su) + dot(v, sv)) / 2;
    const float x = (dot(u, su) - dot(v, sv)) / 2, y = dot(u, sv);
    // From doubles: hypotf() differs between C libraries.
    const float range = float(std::sqrt(double(x) * x + double(y) * y));
    const float k1 = mean + range, k2 = mean - range;
    if (!(k1 >= kLeastCurvature) || !(k1 > kDominance * std::abs(k2))) return {};
    Bend bend;
    bend.curvature = k1;
    bend.direction =
        unit(x > 0 ? ((range + x) * u + y * v).eval() : (y * u + (range - x) * v).eval());
    bend.derivative = sign * dot(bend.direction, laplacian);
    return bend;
}

/// Finds the pieces of ridges in one cluster.
class ClusterRidges {
public:
    ClusterRidges(const PlacedCluster& placed, float sign) : placed_(placed) {
        for (unsigned v = 0; v < placed.cluster->vertex_count; ++v)
            bends_[v] = bend(placed.records[v], vector_of_form(placed.laplacians, v), sign);
    }

    void add(unsigned triangle, ZeroPieces& pieces) const {
        const auto& t = placed_.triangle(triangle).corners;
        const Bend* b[3] = {&bends_[t[0]], &bends_[t[1]], &bends_[t[2]]};
        if (b[0]->curvature == 0 || b[1]->curvature == 0 || b[2]->curvature == 0) return;
        const float sign[3] = {1, sign_to(*b[0], *b[1]), sign_to(*b[0], *b[2])};
        // The directions have a singularity inside, so there is no ridge.
        if (sign[1] * sign[2] * sign_to(*b[1], *b[2]) < 0) return;
        float f[3];
        Eigen::Vector3f e = Eigen::Vector3f::Zero();
        for (int k = 0; k < 3; ++k) {
            f[k] = sign[k] * b[k]->derivative;
            e += sign[k] * b[k]->direction;
        }
        const bool is_negative[3] = {f[0] < 0, f[1] < 0, f[2] < 0};
        if (is_negative[0] == is_negative[1] && is_negative[0] == is_negative[2]) return;
        if (!falls_along(t, f, e)) return;
        pieces.push_back(zero_piece(placed_, triangle, is_negative, [&](unsigned a, unsigned b) {
            return std::make_pair(end(bends_[a], 1), end(bends_[b], sign_to(bends_[a], bends_[b])));
        }));
    }

private:
    static ZeroEnd end(const Bend& bend, float sign) {
        return {bend.derivative, sign * (bend.curvature * bend.direction), 0};
    }

    static float sign_to(const Bend& a, const Bend& b) {
        return dot(a.direction, b.direction) < 0 ? -1.f : 1.f;
    }

    Eigen::Vector3f position(unsigned v) const { return position_of(placed_.records[v]); }

    /// Whether the linear interpolant of f falls along e: a maximum of the curvature.
    bool falls_along(const std::uint8_t t[3], const float f[3], const Eigen::Vector3f& e) const {
        const Eigen::Vector3f a = position(t[0]);
        const Eigen::Vector3f u = position(t[1]) - a;
        const Eigen::Vector3f v = position(t[2]) - a;
        const Eigen::Vector3f area = u.cross(v);
        const Eigen::Vector3f df = (f[1] - f[0]) * v.cross(area) + (f[2] - f[0]) * area.cross(u);
        return dot(df, e) < 0;
    }

    const PlacedCluster& placed_;
    Bend bends_[kClusterVertices];
};

}  // namespace

ZeroLines find_ridge_candidates(const ExtractorData& data, Crest crest) {
    return find_zero_lines<ClusterRidges>(data, crest.kind, kLeastRidgeLength / kMostSharpness,
                                          crest.sign);
}

}  // namespace laplacian_lines
