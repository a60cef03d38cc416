// SPDX-License-Identifier: GPL-3.0-or-later
#include "gaussian_sums.h"

#include <algorithm>
#include <cmath>

#include "gaussian_sums_simd.h"

namespace laplacian_lines {
namespace {

constexpr double kLog2E = 1.4426950408889634;
constexpr float kAnySide = -2.f;  // below every cosine

/// One leaf of the tree, whose points are the targets.
class LeafSum {
public:
    LeafSum(const PreparedMesh& mesh, const SpatialTree& tree,
            const std::vector<Eigen::Vector3d>& normals, const GaussianKernel& kernel,
            const SpatialTree::Leaf& leaf)
        : mesh_(mesh), tree_(tree), normals_(normals), kernel_(kernel), leaf_(leaf) {
        centre_ = leaf.box.center();
        for (std::uint32_t v = leaf.begin; v < leaf.end; ++v) {
            reference_normal_ += normals[v] / double(leaf.end - leaf.begin);
            radius_ = std::max(radius_, kernel.cutoff * kernel.kernel_sizes[v]);
        }
    }

    void collect_sources(std::vector<GaussianSource>& sources) const {
        sources.clear();
        const Eigen::Array3f half_size = (leaf_.box.sizes() / 2).cast<float>();
        const float squared_radius = float(radius_ * radius_);
        tree_.visit_leaves(leaf_.box, radius_, [&](const SpatialTree::Leaf& other) {
            for (std::uint32_t v = other.begin; v < other.end; ++v) {
                const Eigen::Vector3f p = (mesh_.positions[v] - centre_).cast<float>();
                const Eigen::Array3f outside = (p.array().abs() - half_size).max(0.f);
                if (outside.matrix().squaredNorm() > squared_radius) continue;
                const Eigen::Vector3f n = (normals_[v] - reference_normal_).cast<float>();
                sources.push_back(
                    {p.x(), p.y(), p.z(), float(mesh_.masses[v]), n.x(), n.y(), n.z(), 0});
            }
        });
    }

    GaussianTargets targets(std::uint32_t begin) const {
        GaussianTargets t;
        for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
            const std::uint32_t v = std::min(begin + lane, leaf_.end - 1);
            const Eigen::Vector3f p = (mesh_.positions[v] - centre_).cast<float>();
            const Eigen::Vector3f n = normals_[v].cast<float>();
            t.x[lane] = p.x(), t.y[lane] = p.y(), t.z[lane] = p.z();
            t.nx[lane] = n.x(), t.ny[lane] = n.y(), t.nz[lane] = n.z();
            t.reference_cosine[lane] = float(normals_[v].dot(reference_normal_));
            const double size = kernel_.kernel_sizes[v];
            t.squared_cutoff[lane] = float(std::pow(kernel_.cutoff * size, 2));
            t.exponent[lane] = float(-kLog2E / (4 * size * size));
        }
        t.normal_exponent = float(-2 * kLog2E * kernel_.normal_falloff);
        t.least_cosine = kernel_.same_side ? 0.f : kAnySide;
        return t;
    }

    void write(const GaussianLaneSums& s, std::uint32_t begin, GaussianSums& sums) const {
        for (std::uint32_t lane = 0; lane < std::min<std::uint32_t>(kLanes, leaf_.end - begin);
             ++lane) {
            const std::uint32_t v = begin + lane;
            sums.mass[v] = s.mass[lane];
            sums.first_moment[v] = {s.mx[lane], s.my[lane], s.mz[lane]};
            sums.normal_difference[v] =
                Eigen::Vector3f(s.nx[lane], s.ny[lane], s.nz[lane]) -
                s.mass[lane] * (normals_[v] - reference_normal_).cast<float>();
        }
    }

private:
    const PreparedMesh& mesh_;
    const SpatialTree& tree_;
    const std::vector<Eigen::Vector3d>& normals_;
    const GaussianKernel& kernel_;
    const SpatialTree::Leaf& leaf_;
    Eigen::Vector3d centre_;
    Eigen::Vector3d reference_normal_ = Eigen::Vector3d::Zero();
    double radius_ = 0;
};

}  // namespace

GaussianSums gaussian_sums(const PreparedMesh& mesh, const SpatialTree& tree,
                           const std::vector<Eigen::Vector3d>& normals,
                           const GaussianKernel& kernel, const StageProgress& stage) {
    GaussianSums sums;
    sums.mass.resize(mesh.size());
    sums.first_moment.resize(mesh.size());
    sums.normal_difference.resize(mesh.size());
    parallel_for<std::vector<GaussianSource>>(
        tree.leaves().size(), stage, [&](std::size_t i, std::vector<GaussianSource>& sources) {
            const SpatialTree::Leaf& leaf = tree.leaves()[i];
            const LeafSum leaf_sum(mesh, tree, normals, kernel, leaf);
            leaf_sum.collect_sources(sources);
            for (std::uint32_t begin = leaf.begin; begin < leaf.end; begin += kLanes) {
                GaussianLaneSums lanes;
                sum_gaussians(leaf_sum.targets(begin), sources.data(), sources.size(), lanes);
                leaf_sum.write(lanes, begin, sums);
            }
        });
    return sums;
}

}  // namespace laplacian_lines
