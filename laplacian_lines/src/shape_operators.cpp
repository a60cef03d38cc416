// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape_operators.h"

#include <Eigen/Dense>
#include <cmath>

namespace laplacian_lines {
namespace {

/// A symmetric tensor in the plane of a triangle with unit normal n.
struct TriangleTensor {
    Eigen::Vector3d n, t, b;  // orthonormal
    double tt, tb, bb;

    bool finite() const { return std::isfinite(tt + tb + bb); }

    /// Adds `weight` times the tensor turned, with its plane, from n to the unit normal m; false
    /// for opposite normals, where no turn is the shortest.
    bool add_turned_to(const Eigen::Vector3d& m, double weight, SymmetricTensor& sum) const {
        const double cosine = n.dot(m);
        if (!(cosine > -0.999)) return false;
        const Eigen::Vector3d middle = (n + m) / (1 + cosine);
        const Eigen::Vector3d u = t - t.dot(m) * middle, v = b - b.dot(m) * middle;
        sum.add_product(weight * u, tt / 2 * u + tb * v);
        sum.add_product(weight * v, bb / 2 * v);
        return true;
    }
};

/// The symmetric 2x2 matrix that best takes each edge to the change of the normal along it
/// (Rusinkiewicz 2004, section 3).
TriangleTensor fit_triangle(const Eigen::Vector3d edges[3], const Eigen::Vector3d changes[3],
                            const Eigen::Vector3d& face_normal, double twice_area) {
    TriangleTensor tensor{face_normal, edges[0].normalized(), {}, 0, 0, 0};
    tensor.b = face_normal.cross(tensor.t);
    double uu = 0, uv = 0, vv = 0, ru = 0, rm = 0, rv = 0;
    for (int k = 0; k < 3; ++k) {
        const double u = edges[k].dot(tensor.t), v = edges[k].dot(tensor.b);
        const double du = changes[k].dot(tensor.t), dv = changes[k].dot(tensor.b);
        uu += u * u, uv += u * v, vv += v * v;
        ru += du * u, rm += du * v + dv * u, rv += dv * v;
    }
    // Normal equations with the rows (uu, uv, 0), (uv, uu + vv, uv), (0, uv, vv), by cofactors.
    // uu·vv − uv² is the sum of the squared products of two edges: no cancellation in slivers.
    const double squares = 3 * twice_area * twice_area;
    const double scale = 1 / ((uu + vv) * squares);
    tensor.tt = scale * ((vv * vv + squares) * ru - uv * vv * rm + uv * uv * rv);
    tensor.tb = scale * (uu * vv * rm - uv * (vv * ru + uu * rv));
    tensor.bb = scale * ((uu * uu + squares) * rv - uv * uu * rm + uv * uv * ru);
    return tensor;
}

TriangleTensor fit_triangle(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
                            const Triangle& t, const Eigen::Vector3d& area, double twice_area) {
    Eigen::Vector3d edges[3], changes[3];
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t from = t[(k + 1) % 3], to = t[(k + 2) % 3];
        edges[k] = mesh.positions[to] - mesh.positions[from];
        changes[k] = normals[to] - normals[from];
    }
    return fit_triangle(edges, changes, area / twice_area, twice_area);
}

}  // namespace

ShapeOperators fit_triangles(const PreparedMesh& mesh, const VertexRanges& ranges,
                             const std::vector<Eigen::Vector3d>& normals,
                             const StageProgress& stage) {
    ShapeOperators sums(mesh.size());
    std::vector<double> weights(mesh.size(), 0);
    ranges.for_each(stage, [&](const VertexRanges::Range& range) {
        range.for_each_triangle([&](const Triangle& t) {
            const Eigen::Vector3d area = area_vector(mesh, t);
            const double weight = area.norm();
            const TriangleTensor tensor = fit_triangle(mesh, normals, t, area, weight);
            if (!tensor.finite()) return;  // a sliver whose fit has no solution
            for (std::uint32_t v : t)
                if (range.holds(v) && tensor.add_turned_to(normals[v], weight, sums[v]))
                    weights[v] += weight;
        });
        for (std::uint32_t v = range.begin(); v < range.end(); ++v) {
            if (!(weights[v] > 0)) continue;
            sums[v].scale(1 / weights[v]);
            sums[v] = sums[v].tangential(normals[v]);
        }
    });
    return sums;
}

ShapeOperators fit_balls(const PreparedMesh& mesh, const SpatialTree& tree,
                         const std::vector<Eigen::Vector3d>& normals, double radius, bool same_side,
                         const ShapeOperators& fallback, const StageProgress& stage) {
    ShapeOperators operators = fallback;
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
        operators[i] = SymmetricTensor::of(frame * (lhs.inverse() * rhs)).tangential(n);
    });
    return operators;
}

void smooth_over_one_rings(const PreparedMesh& mesh, const VertexRanges& ranges,
                           const std::vector<Eigen::Vector3d>& normals, int passes,
                           const StageProgress& stage, ShapeOperators& operators) {
    ShapeOperators smoothed(mesh.size());
    std::vector<int> counts(mesh.size());
    for (int pass = 0; pass < passes; ++pass) {
        const StageProgress part =
            stage.part(double(pass) / double(passes), double(pass + 1) / double(passes));
        ranges.for_each(part, [&](const VertexRanges::Range& range) {
            for (std::uint32_t v = range.begin(); v < range.end(); ++v)
                smoothed[v] = {}, counts[v] = 0;
            const auto add = [&](std::uint32_t to, std::uint32_t from) {
                if (!range.holds(to)) return;
                smoothed[to].add(operators[from], 1);
                ++counts[to];
            };
            range.for_each_triangle([&](const Triangle& t) {
                for (int k = 0; k < 3; ++k) {
                    const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                    if (normals[a].dot(normals[b]) <= 0) continue;  // the tensor of another side
                    add(a, b);
                    add(b, a);
                }
            });
            for (std::uint32_t v = range.begin(); v < range.end(); ++v) {
                SymmetricTensor mean = operators[v];
                if (counts[v] > 0) {
                    mean.scale(0.5);
                    mean.add(smoothed[v], 0.5 / counts[v]);
                    mean = mean.tangential(normals[v]);
                }
                smoothed[v] = mean;
            }
        });
        operators.swap(smoothed);
    }
}

}  // namespace laplacian_lines
