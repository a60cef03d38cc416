// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/shape_operators.h"

#include <Eigen/Dense>

#include "field/triangle_tensors.h"
#include "system/large_array.h"
#include "system/simd_sets.h"

namespace laplacian_lines {
namespace {

class TriangleFits {
public:
    TriangleFits(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
                 const VertexRanges::Range& range, ShapeOperators& sums,
                 std::vector<double>& weights)
        : mesh_(mesh), normals_(normals), range_(range), sums_(sums), weights_(weights) {}

    void add(const Triangle& t) {
        for (int k = 0; k < 3; ++k)
            for (int axis = 0; axis < 3; ++axis) {
                batch_.positions[k][axis][count_] = mesh_.positions[t[k]][axis];
                batch_.normals[k][axis][count_] = normals_[t[k]][axis];
            }
        triangles_[count_] = &t;
        if (++count_ == TriangleBatch::kSize) flush();
    }

    void flush() {
        fastest<TensorLoops>().fit(batch_, fitted_);
        for (int lane = 0; lane < count_; ++lane)
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t v = (*triangles_[lane])[k];
                if (!range_.holds(v) || !fitted_.has(k, lane)) continue;
                const auto& entries = fitted_.tensors[k];
                SymmetricTensor& sum = sums_[v];
                sum.xx += entries[TensorBatch::kXX][lane],
                    sum.yy += entries[TensorBatch::kYY][lane];
                sum.zz += entries[TensorBatch::kZZ][lane],
                    sum.yz += entries[TensorBatch::kYZ][lane];
                sum.xz += entries[TensorBatch::kXZ][lane],
                    sum.xy += entries[TensorBatch::kXY][lane];
                weights_[v] += fitted_.weights[lane];
            }
        count_ = 0;
    }

private:
    const PreparedMesh& mesh_;
    const std::vector<Eigen::Vector3d>& normals_;
    const VertexRanges::Range& range_;
    ShapeOperators& sums_;
    std::vector<double>& weights_;
    TriangleBatch batch_ = {};
    TensorBatch fitted_ = {};
    const Triangle* triangles_[TriangleBatch::kSize] = {};
    int count_ = 0;
};

/// Calls add(vertex, sum, count) with the summed tensors of each corner's neighbours in the
/// triangle, without those whose normals turn by more than a right angle: these are on another
/// side.
template <class Add>
void add_neighbours(const Triangle& t, const std::vector<Eigen::Vector3d>& normals,
                    const ShapeOperators& operators, Add add) {
    const auto sum = [](SymmetricTensor a, const SymmetricTensor& b) {
        a.add(b, 1);
        return a;
    };
    const SymmetricTensor* const tensors[3] = {&operators[t[0]], &operators[t[1]],
                                               &operators[t[2]]};
    const Eigen::Vector3d* const n[3] = {&normals[t[0]], &normals[t[1]], &normals[t[2]]};
    bool joined[3];  // edge k: corners k and k + 1
    for (int k = 0; k < 3; ++k)
        joined[k] = n[k]->dot(*n[(k + 1) % 3]) > 0;
    if (joined[0] && joined[1] && joined[2]) {
        for (int k = 0; k < 3; ++k)
            add(t[k], sum(*tensors[(k + 1) % 3], *tensors[(k + 2) % 3]), 2);
        return;
    }
    for (int k = 0; k < 3; ++k) {
        if (!joined[k]) continue;
        add(t[k], *tensors[(k + 1) % 3], 1);
        add(t[(k + 1) % 3], *tensors[k], 1);
    }
}

}  // namespace

ShapeOperators fit_triangles(const PreparedMesh& mesh, const VertexRanges& ranges,
                             const std::vector<Eigen::Vector3d>& normals,
                             const StageProgress& stage) {
    ShapeOperators sums = large_array<SymmetricTensor>(mesh.size());
    std::vector<double> weights = large_array(mesh.size(), 0.);
    ranges.for_each(stage, [&](const VertexRanges::Range& range) {
        range.prefetch(mesh.positions);
        range.prefetch(normals);
        TriangleFits fits(mesh, normals, range, sums, weights);
        range.for_each_triangle([&](const Triangle& t) { fits.add(t); });
        fits.flush();
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
        if (!(lhs.determinant() > 1e-6 * lhs.trace() * lhs.trace())) return;
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
            const auto add = [&](std::uint32_t to, const SymmetricTensor& sum, int count) {
                if (!range.holds(to)) return;
                smoothed[to].add(sum, 1);
                counts[to] += count;
            };
            range.for_each_triangle(
                [&](const Triangle& t) { add_neighbours(t, normals, operators, add); });
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
