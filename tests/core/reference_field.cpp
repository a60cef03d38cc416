// SPDX-License-Identifier: GPL-3.0-or-later
// The field by its definitions alone: sums over all pairs of vertices, with no tree and no grid.
#include "reference.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace reference {
namespace {

constexpr double kPi = 3.14159265358979323846;

using laplacian_lines::NormalWeighting;
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

double weight(NormalWeighting weighting, const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
    const double sine = u.cross(v).norm() / (u.norm() * v.norm());
    const double cosine = u.dot(v) / (u.norm() * v.norm());
    if (weighting == NormalWeighting::Angle) return std::atan2(sine, cosine);
    if (weighting == NormalWeighting::Max) return sine / (u.norm() * v.norm());
    return u.cross(v).norm();
}

constexpr int kPasses = 10;    // as PrecomputeOptions::kernel_mode has it
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

Vectors normals(const TriangleMesh& mesh, NormalWeighting weighting) {
    Vectors n(mesh.positions.size(), Eigen::Vector3d::Zero());
    for_each_corner(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const Eigen::Vector3d u = mesh.positions[b] - mesh.positions[a];
        const Eigen::Vector3d v = mesh.positions[c] - mesh.positions[a];
        n[a] += weight(weighting, u, v) * area_vector(mesh, a, b, c).normalized();
    });
    for (Eigen::Vector3d& x : n)
        x.normalize();
    return n;
}

std::vector<double> relative_sizes(const TriangleMesh& mesh) {
    std::vector<double> sizes(mesh.positions.size(), 0), counts(sizes);
    for_each_corner(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        sizes[a] += (mesh.positions[a] - mesh.positions[b]).norm() +
                    (mesh.positions[a] - mesh.positions[c]).norm();
        counts[a] += 2;
    });
    for (std::size_t v = 0; v < sizes.size(); ++v)
        sizes[v] /= counts[v];
    for (int pass = 0; pass < kPasses; ++pass) {
        std::vector<double> sums = sizes;
        for_each_corner(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            sums[a] += sizes[b] + sizes[c];
        });
        for (std::size_t v = 0; v < sizes.size(); ++v)
            sizes[v] = sums[v] / (counts[v] + 1);
    }
    const double mean = mean_edge(mesh);
    for (double& size : sizes)
        size = std::clamp(size / mean, 0.25, 4.0);
    return sizes;
}

Vectors smoothed(const TriangleMesh& mesh, const Vectors& normals, double sigma,
                 double bilateral_angle) {
    const std::vector<double> m = masses(mesh);
    const double chord = 2 * std::sin(bilateral_angle * kPi / 360);
    Vectors result(normals.size(), Eigen::Vector3d::Zero());
    for (std::size_t p = 0; p < normals.size(); ++p) {
        for (std::size_t q = 0; q < normals.size(); ++q) {
            const double distance = (mesh.positions[q] - mesh.positions[p]).norm() / sigma;
            if (distance > kCutoff) continue;
            double w =
                m[q] * facing_weight(normals[q], normals[p]) * std::exp(-distance * distance / 2);
            if (chord > 0)
                w *= std::exp(-(normals[q] - normals[p]).squaredNorm() / (2 * chord * chord));
            result[p] += w * normals[q];
        }
        result[p].normalize();
    }
    return result;
}

Vectors laplacian(const TriangleMesh& mesh, const Vectors& normals,
                  const std::vector<double>& kernel_sizes, bool skip_opposite_sheet) {
    const std::vector<double> m = masses(mesh);
    Vectors result(normals.size(), Eigen::Vector3d::Zero());
    for (std::size_t p = 0; p < normals.size(); ++p) {
        const double h = kernel_sizes[p] * kernel_sizes[p];
        for (std::size_t q = 0; q < normals.size(); ++q) {
            const double squared = (mesh.positions[q] - mesh.positions[p]).squaredNorm();
            const double facing = skip_opposite_sheet ? facing_weight(normals[q], normals[p]) : 1;
            result[p] += m[q] * facing * std::exp(-squared / (4 * h)) * (normals[q] - normals[p]);
        }
        result[p] /= 4 * kPi * h * h;
    }
    return result;
}

}  // namespace reference
