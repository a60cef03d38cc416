// SPDX-License-Identifier: GPL-3.0-or-later
// The field by its definitions alone: sums over all pairs of vertices, with no tree and no grid.
#include "reference.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace reference {
namespace {

using laplacian_lines::Triangle;

/// visit(corner, next, previous), for all triangles.
template <class Visit>
void for_each_corner(const TriangleMesh& mesh, Visit visit) {
    for (const Triangle& t : mesh.triangles)
        for (int k = 0; k < 3; ++k)
            visit(t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
}

Eigen::Vector3d area_vector(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b,
                            std::uint32_t c) {
    const auto& p = mesh.positions;
    return (p[b] - p[a]).cross(p[c] - p[a]) / 2;
}

constexpr double kCutoff = 3;  // deviations, beyond which smoothing takes no normals

/// 1 for equal normals, 0 for opposite ones, smooth in the cosine.
double facing_weight(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double s = (1 + a.dot(b)) / 2;
    return s * s * (3 - 2 * s);
}

std::vector<double> masses(const TriangleMesh& mesh) {
    std::vector<double> m(mesh.positions.size(), 0);
    for_each_corner(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        m[a] += area_vector(mesh, a, b, c).norm() / 3;
    });
    return m;
}

}  // namespace

double mean_edge(const TriangleMesh& mesh) {
    double sum = 0;
    for_each_corner(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t) {
        sum += (mesh.positions[a] - mesh.positions[b]).norm();
    });
    return sum / double(3 * mesh.triangles.size());
}

double diagonal(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : mesh.positions)
        box.extend(p);
    return box.diagonal().norm();
}

Vectors normals(const TriangleMesh& mesh) {
    Vectors n(mesh.positions.size(), Eigen::Vector3d::Zero());
    for_each_corner(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        n[a] += area_vector(mesh, a, b, c);
    });
    for (Eigen::Vector3d& x : n)
        x.normalize();
    return n;
}

Vectors smoothed(const TriangleMesh& mesh, const Vectors& normals, double sigma) {
    const std::vector<double> m = masses(mesh);
    Vectors result(normals.size(), Eigen::Vector3d::Zero());
    for (std::size_t p = 0; p < normals.size(); ++p) {
        for (std::size_t q = 0; q < normals.size(); ++q) {
            const double distance = (mesh.positions[q] - mesh.positions[p]).norm() / sigma;
            if (distance > kCutoff) continue;
            result[p] += m[q] * facing_weight(normals[q], normals[p]) *
                         std::exp(-distance * distance / 2) * normals[q];
        }
        result[p].normalize();
    }
    return result;
}

Vectors laplacian(const TriangleMesh& mesh, const Vectors& normals, double kernel_size,
                  bool skip_opposite_sheet) {
    const std::vector<double> m = masses(mesh);
    const double h = kernel_size * kernel_size;
    Vectors result(normals.size(), Eigen::Vector3d::Zero());
    for (std::size_t p = 0; p < normals.size(); ++p) {
        for (std::size_t q = 0; q < normals.size(); ++q) {
            const double squared = (mesh.positions[q] - mesh.positions[p]).squaredNorm();
            const double facing = skip_opposite_sheet ? facing_weight(normals[q], normals[p]) : 1;
            result[p] += m[q] * facing * std::exp(-squared / (4 * h)) * (normals[q] - normals[p]);
        }
        result[p] /= 4 * M_PI * h * h;
    }
    return result;
}

}  // namespace reference
