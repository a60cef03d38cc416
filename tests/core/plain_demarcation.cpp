// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_derivatives.h"

#include <cmath>

#include "laplacian_lines/tangent_frame.h"

namespace reference {
namespace {

using namespace laplacian_lines;

struct Vertex {
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    double curvature = 0, strength = 0;
};

double cubic(const Eigen::Vector4d& c, double angle) {
    const double x = std::cos(angle), y = std::sin(angle);
    return c[0] * x * x * x + 3 * c[1] * x * x * y + 3 * c[2] * x * y * y + c[3] * y * y * y;
}

/// The largest of many directions, refined by halving steps; none if another maximum has 0.9 of it.
Vertex vertex_of(const Field& field, std::size_t v) {
    constexpr int kCount = 720;
    constexpr double kStep = 2 * 3.14159265358979 / kCount;
    const Eigen::Vector4d c = field.curvature_derivatives[v].cast<double>();
    const auto at = [&](int i) { return cubic(c, kStep * i); };
    int best = 0;
    for (int i = 0; i < kCount; ++i)
        if (at(i) > at(best)) best = i;
    Vertex vertex;
    if (!(at(best) > 0)) return vertex;
    for (int i = 0; i < kCount; ++i)
        if (i != best && at(i) >= at(i - 1) && at(i) >= at(i + 1) && at(i) > 0.9 * at(best) &&
            std::abs(i - best) % (kCount - 3) > 3)
            return vertex;
    double angle = kStep * best;
    for (double step = kStep; step > 1e-9; step /= 2)
        for (const double other : {angle - step, angle + step})
            if (cubic(c, other) > cubic(c, angle)) angle = other;
    const TangentFrame frame = tangent_frame(field.normals[v]);
    const double x = std::cos(angle), y = std::sin(angle);
    vertex.direction = x * frame.u.cast<double>() + y * frame.v.cast<double>();
    const Eigen::Vector3d s = field.smooth_curvatures[v].cast<double>();
    vertex.curvature = s[0] * x * x + 2 * s[1] * x * y + s[2] * y * y;
    const double h = std::pow(field.kernel_sizes[v], 2) + std::pow(field.scale.normal_sigma, 2) / 2;
    vertex.strength = cubic(c, angle) * h * 180 / 3.14159265358979;
    return vertex;
}

}  // namespace

std::vector<DemarcatingPiece> demarcating_pieces(const TriangleMesh& mesh, const Field& field) {
    std::vector<Vertex> vertices;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        vertices.push_back(vertex_of(field, v));
    std::vector<DemarcatingPiece> pieces;
    for (const Triangle& t : mesh.triangles) {
        DemarcatingPiece piece;
        int found = 0;
        bool agree = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t i = t[k], j = t[(k + 1) % 3];
            const Vertex &a = vertices[i], &b = vertices[j];
            agree = agree && a.direction.dot(b.direction) > std::sqrt(0.5);
            if ((a.curvature < 0) == (b.curvature < 0)) continue;
            const double s = a.curvature / (a.curvature - b.curvature);
            piece.ends[found] = (1 - s) * mesh.positions[i] + s * mesh.positions[j];
            piece.strength[found++] = (1 - s) * a.strength + s * b.strength;
        }
        if (agree && found == 2) pieces.push_back(piece);
    }
    return pieces;
}

}  // namespace reference
