// SPDX-License-Identifier: GPL-3.0-or-later
// S, the change of the normal along the surface, by one of two ways:
//  1. fit_triangles(): in each triangle the tensor that best maps its edges to the changes of the
//     normals along them, averaged at each vertex by area after turning it into the vertex's plane
//     (S. Rusinkiewicz, "Estimating Curvatures and Their Derivatives on Triangle Meshes", 2004,
//     who averages by the part of the area around the vertex).
//  2. fit_balls(): at each vertex the tensor that best maps the places of the vertices in a ball to
//     the changes of their normals (Eq. 3 of the paper).
// Then S is averaged with its neighbours.
#include "field/field_steps.h"

#include <Eigen/LU>
#include <cmath>

#include "field/triangle_plane.h"
#include "system/large_array.h"

namespace laplacian_lines {
namespace {

// Between a triangle's normal and a corner's: opposite ones have no unique rotation.
constexpr double kLeastCosine = -0.999;
// Least determinant of the places' second moments over their squared trace: else about on a line.
constexpr double kLeastSpread = 1e-6;

/// The symmetric tensor in a triangle's plane that best maps its edges to the changes of the
/// normals along them: tt t tᵀ + tb (t bᵀ + b tᵀ) + bb b bᵀ.
struct TriangleFit : TrianglePlane {
    double tt, tb, bb;

    TriangleFit(const std::vector<Eigen::Vector3d>& p, const std::vector<Eigen::Vector3d>& normals,
                const Triangle& v)
        : TrianglePlane(p, v) {
        double uu = 0, uv = 0, vv = 0, ru = 0, rm = 0, rv = 0;
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d change = normals[v[(k + 2) % 3]] - normals[v[(k + 1) % 3]];
            const double along = edges[k].dot(t), beside = edges[k].dot(b);
            const double du = change.dot(t), dv = change.dot(b);
            uu += along * along, uv += along * beside, vv += beside * beside;
            ru += du * along, rm += du * beside + dv * along, rv += dv * beside;
        }
        // Normal equations with the rows (uu, uv, 0), (uv, uu + vv, uv), (0, uv, vv) and the right
        // side (ru, rm, rv), by cofactors. uu·vv − uv² is the sum, over pairs of edges, of their
        // squared cross product, each twice the area (Lagrange): no cancellation in slivers.
        const double squares = 3 * twice_area * twice_area, scale = 1 / ((uu + vv) * squares);
        tt = scale * ((vv * vv + squares) * ru - uv * vv * rm + uv * uv * rv);
        tb = scale * (uu * vv * rm - uv * (vv * ru + uu * rv));
        bb = scale * ((uu * uu + squares) * rv - uv * uu * rm + uv * uv * ru);
    }
    /// False for slivers without a solution.
    bool is_finite() const { return std::isfinite(tt + tb + bb); }

    /// Adds the tensor times twice the area, turned with its plane from its normal to m.
    void add_to(SymmetricTensor& sum, const Eigen::Vector3d& m) const {
        const Eigen::Vector3d turned_t = turned(t, n, m), turned_b = turned(b, n, m);
        sum.add_product(turned_t, twice_area * (tt / 2 * turned_t + tb * turned_b));
        sum.add_product(turned_b, twice_area * bb / 2 * turned_b);
    }
};

}  // namespace

ShapeOperators fit_triangles(const PreparedMesh& mesh, const VertexRanges& ranges,
                             const std::vector<Eigen::Vector3d>& normals,
                             const StageProgress& stage) {
    ShapeOperators sums = large_array<SymmetricTensor>(mesh.size());
    std::vector<double> weights = large_array(mesh.size(), 0.);
    ranges.for_each(stage, [&](const VertexRanges::Range& range) {
        range.prefetch(mesh.positions);
        range.prefetch(normals);
        range.for_each_triangle([&](const Triangle& t) {
            const TriangleFit fit(mesh.positions, normals, t);
            if (!fit.is_finite()) return;
            for (const std::uint32_t v : t) {
                if (!range.holds(v) || !(fit.n.dot(normals[v]) > kLeastCosine)) continue;
                fit.add_to(sums[v], normals[v]);
                weights[v] += fit.twice_area;
            }
        });
        for (std::uint32_t v = range.begin(); v < range.end(); ++v)
            if (weights[v] > 0) sums[v].scale(1 / weights[v]);
    });
    return sums;
}

ShapeOperators fit_balls(const PreparedMesh& mesh, const SpatialTree& tree,
                         const std::vector<Eigen::Vector3d>& normals, double radius, bool same_side,
                         ShapeOperators operators, const StageProgress& stage) {
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
        if (!(lhs.determinant() > kLeastSpread * lhs.trace() * lhs.trace())) return;
        // the fit is Sᵀ, whose symmetric part is that of S
        operators[i] = SymmetricTensor::of(frame * (lhs.inverse() * rhs)).tangential(n);
    });
    return operators;
}

void smooth_over_one_rings(const PreparedMesh& mesh, const VertexRanges& ranges,
                           const std::vector<Eigen::Vector3d>& normals, int passes,
                           const StageProgress& stage, ShapeOperators& operators) {
    ShapeOperators smoothed = large_array<SymmetricTensor>(mesh.size());
    std::vector<int> counts(mesh.size());
    for (int pass = 0; pass < passes; ++pass) {
        const StageProgress part =
            stage.part(double(pass) / double(passes), double(pass + 1) / double(passes));
        ranges.for_each(part, [&](const VertexRanges::Range& range) {
            range.prefetch(operators);
            range.prefetch(normals);
            for (std::uint32_t v = range.begin(); v < range.end(); ++v)
                smoothed[v] = {}, counts[v] = 0;
            range.for_each_triangle([&](const Triangle& t) {
                const auto add = [&](std::uint32_t v, std::uint32_t other) {
                    if (!range.holds(v)) return;
                    smoothed[v].add(operators[other], 1);
                    ++counts[v];
                };
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                    // Where normals turn by more than a right angle, S is of another side.
                    if (!(normals[a].dot(normals[b]) > 0)) continue;
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
