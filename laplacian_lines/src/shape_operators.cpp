// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape_operators.h"

#include <Eigen/Dense>

namespace laplacian_lines {
namespace {

/// The symmetric part of A, restricted to the plane orthogonal to n.
Eigen::Matrix3d tangential(const Eigen::Matrix3d& a, const Eigen::Vector3d& n) {
    const Eigen::Matrix3d p = Eigen::Matrix3d::Identity() - n * n.transpose();
    const Eigen::Matrix3d t = p * a * p;
    return (t + t.transpose()) / 2;
}

/// A symmetric tensor in the plane of a triangle with unit normal n.
struct TriangleTensor {
    Eigen::Vector3d n, t, b;  // orthonormal
    Eigen::Vector3d entries;  // tt, tb, bb

    /// The tensor turned, with its plane, from n to the unit normal m; false for opposite normals,
    /// where no turn is the shortest.
    bool turned_to(const Eigen::Vector3d& m, Eigen::Matrix3d& result) const {
        const double cosine = n.dot(m);
        if (!(cosine > -0.999)) return false;
        const Eigen::Vector3d middle = (n + m) / (1 + cosine);
        const Eigen::Vector3d u = t - t.dot(m) * middle, v = b - b.dot(m) * middle;
        const Eigen::Matrix3d uv = u * v.transpose();
        result = entries[0] * u * u.transpose() + entries[1] * (uv + uv.transpose()) +
                 entries[2] * v * v.transpose();
        return true;
    }
};

/// The symmetric 2x2 matrix that best takes each edge to the change of the normal along it
/// (Rusinkiewicz 2004, section 3).
TriangleTensor fit_triangle(const Eigen::Vector3d edges[3], const Eigen::Vector3d changes[3],
                            const Eigen::Vector3d& face_normal) {
    TriangleTensor tensor{face_normal, edges[0].normalized(), {}, {}};
    tensor.b = face_normal.cross(tensor.t);
    Eigen::Matrix3d lhs = Eigen::Matrix3d::Zero();
    Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
        const double u = edges[k].dot(tensor.t), v = edges[k].dot(tensor.b);
        const double du = changes[k].dot(tensor.t), dv = changes[k].dot(tensor.b);
        lhs(0, 0) += u * u;
        lhs(0, 1) += u * v;
        lhs(2, 2) += v * v;
        rhs += Eigen::Vector3d(du * u, du * v + dv * u, dv * v);
    }
    lhs(1, 1) = lhs(0, 0) + lhs(2, 2);
    lhs(1, 0) = lhs(1, 2) = lhs(2, 1) = lhs(0, 1);
    tensor.entries = lhs.ldlt().solve(rhs);
    return tensor;
}

}  // namespace

std::vector<Eigen::Matrix3d> fit_triangles(const PreparedMesh& mesh,
                                           const std::vector<Eigen::Vector3d>& normals) {
    std::vector<Eigen::Matrix3d> sums(mesh.size(), Eigen::Matrix3d::Zero());
    std::vector<double> weights(mesh.size(), 0);
    for (const Triangle& t : mesh.triangles) {
        Eigen::Vector3d edges[3], changes[3];
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = t[(k + 1) % 3], to = t[(k + 2) % 3];
            edges[k] = mesh.positions[to] - mesh.positions[from];
            changes[k] = normals[to] - normals[from];
        }
        const Eigen::Vector3d area = area_vector(mesh, t);
        const double weight = area.norm();
        const TriangleTensor tensor = fit_triangle(edges, changes, area / weight);
        if (!tensor.entries.allFinite()) continue;  // a sliver whose fit has no solution
        for (std::uint32_t v : t) {
            Eigen::Matrix3d turned;
            if (!tensor.turned_to(normals[v], turned)) continue;
            sums[v] += weight * turned;
            weights[v] += weight;
        }
    }
    for (std::size_t v = 0; v < sums.size(); ++v)
        if (weights[v] > 0) sums[v] = tangential(sums[v] / weights[v], normals[v]);
    return sums;
}

std::vector<Eigen::Matrix3d> fit_balls(const PreparedMesh& mesh, const SpatialTree& tree,
                                       const std::vector<Eigen::Vector3d>& normals, double radius,
                                       bool same_side, const std::vector<Eigen::Matrix3d>& fallback,
                                       const StageProgress& stage) {
    std::vector<Eigen::Matrix3d> operators = fallback;
    parallel_for<NoScratch>(mesh.size(), stage, [&](std::size_t i, NoScratch&) {
        const Eigen::Vector3d &p = mesh.positions[i], &n = normals[i];
        Eigen::Matrix<double, 3, 2> frame;
        frame.col(0) = n.unitOrthogonal();
        frame.col(1) = n.cross(frame.col(0));
        Eigen::Matrix2d lhs = Eigen::Matrix2d::Zero();
        Eigen::Matrix<double, 2, 3> rhs = Eigen::Matrix<double, 2, 3>::Zero();
        tree.visit_leaves(Eigen::AlignedBox3d(p), radius, [&](const SpatialTree::Leaf& leaf) {
            for (std::uint32_t q = leaf.begin; q < leaf.end; ++q) {
                const Eigen::Vector3d d = mesh.positions[q] - p;
                if (d.squaredNorm() > radius * radius) continue;
                if (same_side && normals[q].dot(n) <= 0) continue;
                const Eigen::Vector2d u = frame.transpose() * d;
                lhs += u * u.transpose();
                rhs += u * (normals[q] - n).transpose();
            }
        });
        // Well determined only if the neighbours spread in both directions.
        if (!(lhs.determinant() > 1e-6 * lhs.trace() * lhs.trace())) return;
        operators[i] = tangential(frame * (lhs.inverse() * rhs), n);
    });
    return operators;
}

void smooth_over_one_rings(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
                           std::vector<Eigen::Matrix3d>& operators) {
    std::vector<Eigen::Matrix3d> sums(mesh.size(), Eigen::Matrix3d::Zero());
    std::vector<int> counts(mesh.size(), 0);
    for (const Triangle& t : mesh.triangles)
        for (int k = 0; k < 3; ++k)
            for (std::uint32_t q : {t[(k + 1) % 3], t[(k + 2) % 3]}) {
                if (normals[q].dot(normals[t[k]]) <= 0) continue;  // the tensor of another side
                sums[t[k]] += operators[q];
                ++counts[t[k]];
            }
    for (std::size_t v = 0; v < sums.size(); ++v)
        if (counts[v] > 0)
            operators[v] = tangential((operators[v] + sums[v] / counts[v]) / 2, normals[v]);
}

}  // namespace laplacian_lines
