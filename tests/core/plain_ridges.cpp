// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_ridges.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "laplacian_lines/tangent_frame.h"

namespace reference {
namespace {

using namespace laplacian_lines;

// What rounding in single precision may change, relative to the terms of a sum.
constexpr double kRounding = 3e-6;
constexpr double kPlaceRounding = 1e-7;  // D
constexpr double kNoHeight = 1e-12;      // of the longest side: a triangle without area

/// Whether all of several conditions hold, and whether that is certain.
class Verdict {
public:
    void require(double positive, double rounding) {
        holds_ = holds_ && positive > 0;
        if (!(std::abs(positive) > rounding))
            unclear_ = true;
        else if (positive < 0)
            refuted_ = true;
    }
    /// What does not matter if this is larger than rounding.
    void doubt(double size, double rounding) { unclear_ = unclear_ || !(size > rounding); }
    bool holds() const { return holds_; }
    bool is_certain() const { return refuted_ || !unclear_; }

private:
    bool holds_ = true, unclear_ = false, refuted_ = false;
};

/// All times the power of D that leaves no unit.
struct Vertex {
    Eigen::Vector3d direction;  // e₁
    double k1, k2;
    double derivative;  // Δn·e₁
    double size;        // of Δn
};

Vertex vertex_of(const Field& field, std::size_t v, double sign) {
    const double d = field.scale.diagonal;
    const TangentFrame frame = tangent_frame(field.normals[v]);
    Eigen::Matrix<double, 3, 2> basis;
    basis << frame.u.cast<double>(), frame.v.cast<double>();
    const ShapeOperator& s = field.shape_operators[v];
    Eigen::Matrix3d shape;
    shape << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(sign * d * basis.transpose() *
                                                               shape * basis);
    const Eigen::Vector3d laplacian = sign * d * d * field.laplacian_normals[v].cast<double>();
    Vertex vertex;
    vertex.k1 = eigen.eigenvalues()[1];
    vertex.k2 = eigen.eigenvalues()[0];
    vertex.direction = basis * eigen.eigenvectors().col(1);
    vertex.derivative = laplacian.dot(vertex.direction);
    vertex.size = laplacian.norm();
    return vertex;
}

/// A triangle's corners; directions turned so that they agree, and derivatives with them.
struct Corners {
    std::uint32_t numbers[3];
    Vertex vertices[3];
    Eigen::Vector3d positions[3];  // D

    double size() const { return std::max({vertices[0].size, vertices[1].size, vertices[2].size}); }
};

void require_sharp_bends(const Corners& t, Verdict& verdict) {
    for (const Vertex& v : t.vertices) {
        const double rounding = kRounding * (std::abs(v.k1) + std::abs(v.k2));
        verdict.require(v.k1 - 4, rounding);
        verdict.require(v.k1 - 2 * std::abs(v.k2), rounding);
    }
}

/// Of all ways to turn the directions, the one in which the two that differ most differ least; by
/// less than a right angle, or they go round a point inside.
void require_agreement(Corners& t, Verdict& verdict) {
    double best = -2, signs[3] = {1, 1, 1};
    for (const double b : {-1., 1.})
        for (const double c : {-1., 1.}) {
            const Eigen::Vector3d e[3] = {t.vertices[0].direction, b * t.vertices[1].direction,
                                          c * t.vertices[2].direction};
            const double least = std::min({e[0].dot(e[1]), e[1].dot(e[2]), e[2].dot(e[0])});
            if (least > best) best = least, signs[1] = b, signs[2] = c;
        }
    verdict.require(best, kRounding);
    for (int k = 0; k < 3; ++k) {
        t.vertices[k].direction *= signs[k];
        t.vertices[k].derivative *= signs[k];
    }
}

void require_zeros(const Corners& t, Verdict& verdict) {
    const double f[3] = {t.vertices[0].derivative, t.vertices[1].derivative,
                         t.vertices[2].derivative};
    const double rounding = kRounding * t.size();
    verdict.require(std::max({f[0], f[1], f[2]}), rounding);
    verdict.require(-std::min({f[0], f[1], f[2]}), rounding);
    // A zero near a corner may be on either side that ends there.
    for (const double value : f)
        verdict.doubt(std::abs(value), rounding);
}

/// The derivative, linear in the triangle, falls along the direction.
void require_maximum(const Corners& t, Verdict& verdict) {
    Eigen::Matrix<double, 3, 2> sides;
    sides << t.positions[1] - t.positions[0], t.positions[2] - t.positions[0];
    const Eigen::Vector2d change(t.vertices[1].derivative - t.vertices[0].derivative,
                                 t.vertices[2].derivative - t.vertices[0].derivative);
    const double longest =
        std::max({sides.col(0).norm(), sides.col(1).norm(), (sides.col(0) - sides.col(1)).norm()});
    const double height = sides.col(0).cross(sides.col(1)).norm() / longest;
    if (!(height > kNoHeight * longest)) return verdict.require(-1, 0);
    const Eigen::Vector3d gradient = sides * (sides.transpose() * sides).inverse() * change;
    const Eigen::Vector3d e =
        t.vertices[0].direction + t.vertices[1].direction + t.vertices[2].direction;
    verdict.require(-gradient.dot(e),
                    e.norm() / height * (kRounding * t.size() + kPlaceRounding * gradient.norm()));
}

RidgeEnd end_between(const Corners& t, int i, int j, const TriangleMesh& mesh) {
    const Vertex &a = t.vertices[i], &b = t.vertices[j];
    const double share = a.derivative / (a.derivative - b.derivative);
    const Eigen::Vector3d from = a.k1 * a.direction, to = b.k1 * b.direction;
    const Eigen::Vector3d &p = mesh.positions[t.numbers[i]], &q = mesh.positions[t.numbers[j]];
    return {
        std::minmax(t.numbers[i], t.numbers[j]), p + share * (q - p), from + share * (to - from),
        kRounding * (a.size + b.size) / std::abs(a.derivative - b.derivative), (to - from).norm()};
}

RidgePiece piece_in(Corners& t, const TriangleMesh& mesh) {
    Verdict verdict;
    require_sharp_bends(t, verdict);
    require_agreement(t, verdict);
    require_zeros(t, verdict);
    require_maximum(t, verdict);
    RidgePiece piece{
        {t.numbers[0], t.numbers[1], t.numbers[2]}, verdict.holds(), verdict.is_certain(), {}};
    std::sort(piece.triangle.begin(), piece.triangle.end());
    if (!piece.is_found) return piece;
    int found = 0;
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        if ((t.vertices[k].derivative < 0) != (t.vertices[next].derivative < 0))
            piece.ends[found++] = end_between(t, k, next, mesh);
    }
    return piece;
}

}  // namespace

std::vector<RidgePiece> ridge_pieces(const TriangleMesh& mesh, const Field& field, LineKind kind) {
    // A valley is a ridge of the surface turned inside out.
    const double sign = kind == LineKind::Valley ? -1 : 1;
    std::vector<Vertex> vertices;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        vertices.push_back(vertex_of(field, v, sign));
    std::vector<RidgePiece> pieces;
    for (const Triangle& t : mesh.triangles) {
        Corners corners;
        for (std::size_t k = 0; k < 3; ++k) {
            corners.numbers[k] = t[k];
            corners.vertices[k] = vertices[t[k]];
            corners.positions[k] = mesh.positions[t[k]] / field.scale.diagonal;
        }
        const RidgePiece piece = piece_in(corners, mesh);
        if (piece.is_found || !piece.is_certain) pieces.push_back(piece);
    }
    return pieces;
}

std::vector<RidgeLine> join_ridges(const std::vector<RidgePiece>& pieces) {
    std::map<Edge, std::vector<std::size_t>> at_edge;
    std::set<Edge> doubtful;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Triangle& t = pieces[i].triangle;
        if (!pieces[i].is_certain) doubtful.insert({{t[0], t[1]}, {t[1], t[2]}, {t[0], t[2]}});
        if (!pieces[i].is_found) continue;
        for (const RidgeEnd& end : pieces[i].ends)
            at_edge[end.edge].push_back(i);
    }
    std::vector<RidgeLine> lines;
    std::vector<bool> is_joined(pieces.size(), false);
    for (std::size_t first = 0; first < pieces.size(); ++first) {
        if (is_joined[first] || !pieces[first].is_found) continue;
        RidgeLine line{{}, 0, true};
        std::vector<std::size_t> to_do = {first};
        while (!to_do.empty()) {
            const std::size_t i = to_do.back();
            to_do.pop_back();
            if (is_joined[i]) continue;
            is_joined[i] = true;
            const RidgePiece& piece = pieces[i];
            line.pieces.push_back((piece.ends[0].position - piece.ends[1].position).norm());
            line.length += line.pieces.back();
            for (const RidgeEnd& end : piece.ends) {
                line.edges.insert(end.edge);
                line.is_certain = line.is_certain && doubtful.count(end.edge) == 0;
                const std::vector<std::size_t>& here = at_edge[end.edge];
                if (here.size() == 2) to_do.insert(to_do.end(), here.begin(), here.end());
            }
        }
        lines.push_back(line);
    }
    return lines;
}

}  // namespace reference
