// SPDX-License-Identifier: GPL-3.0-or-later
// Direct sums, leaf by leaf of the tree: the vertices of a leaf are the targets, and share the
// sources within the cutoff of any of them. Places and normals are relative to the leaf's, for
// floats.
#include "sums/gaussian_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sums/leaf_sources.h"
#include "sums/simd_gaussian_sums.h"
#include "system/simd_sets.h"

namespace laplacian_lines {
namespace {

constexpr double kLog2E = 1.4426950408889634;

/// Positive, even if the areas are 0 as floats.
float mean_mass(const PreparedMesh& mesh) {
    const double sum = sum_of(mesh.size(), [&](std::size_t v) { return mesh.masses[v]; });
    return std::max(float(sum / double(mesh.size())), std::numeric_limits<float>::min());
}

/// The sums at the vertices of one leaf.
class LeafSum {
public:
    LeafSum(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
            const GaussianKernel& kernel, float unit_mass, const SpatialTree::Leaf& leaf)
        : mesh_(mesh),
          normals_(normals),
          kernel_(kernel),
          unit_mass_(unit_mass),
          leaf_(leaf),
          centre_(leaf.box.center()) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::uint32_t v = leaf.begin; v < leaf.end; ++v)
            sum += normals[v];
        mean_normal_ = (sum / double(leaf.end - leaf.begin)).cast<float>();
        quick_ = kernel.quick && leaf.box.diagonal().norm() <= 2 * kQuickRadius * kernel.size;
    }

    void sum(std::uint32_t begin, const std::vector<GaussianSource>& sources, std::size_t count,
             GaussianSums& sums) const {
        GaussianLaneSums lanes = {};
        (quick_ ? loops_.sum_quickly : loops_.sum)(targets(begin), sources.data(), count, lanes);
        write(lanes, begin, sums);
    }

    std::size_t collect(const LeafSources<GaussianSource>& all,
                        std::vector<GaussianSource>& sources) const {
        const std::size_t count = all.collect(leaf_, kernel_.cutoff * kernel_.size, sources);
        for (std::size_t i = 0; i < count; ++i) {
            GaussianSource& s = sources[i];
            s.nx -= mean_normal_.x(), s.ny -= mean_normal_.y(), s.nz -= mean_normal_.z();
            s.squared = s.x * s.x + s.y * s.y + s.z * s.z;
        }
        return count;
    }

private:
    GaussianTargets targets(std::uint32_t begin) const {
        GaussianTargets t;
        for (std::uint32_t lane = 0; lane < kTargets; ++lane) {
            const std::uint32_t v = std::min(begin + lane, leaf_.end - 1);
            const Eigen::Vector3f p = (mesh_.positions[v] - centre_).cast<float>();
            const Eigen::Vector3f n = (normals_[v] - mean_normal_.cast<double>()).cast<float>();
            for (const int axis : {0, 1, 2})
                t.position[axis][lane] = p[axis], t.normal[axis][lane] = n[axis];
        }
        Eigen::Map<Eigen::Vector3f>(t.mean_normal) = mean_normal_;
        t.squared_cutoff = float(std::pow(kernel_.cutoff * kernel_.size, 2));
        t.exponent = float(-kLog2E / (4 * kernel_.size * kernel_.size));
        t.log2_cutoff = float(-kLog2E * kernel_.cutoff * kernel_.cutoff / 4);
        t.unit_mass = unit_mass_;
        t.facing = kernel_.facing ? 1.f : 0.f;
        return t;
    }

    void write(const GaussianLaneSums& s, std::uint32_t begin, GaussianSums& sums) const {
        for (std::uint32_t lane = 0; lane < std::min<std::uint32_t>(kTargets, leaf_.end - begin);
             ++lane) {
            const std::uint32_t v = begin + lane;
            sums.mass[v] = s.mass[lane];
            sums.first_moment[v] = {s.moment[0][lane], s.moment[1][lane], s.moment[2][lane]};
            sums.normal_difference[v] = {s.normal[0][lane], s.normal[1][lane], s.normal[2][lane]};
        }
    }

    const PreparedMesh& mesh_;
    const std::vector<Eigen::Vector3d>& normals_;
    const GaussianKernel& kernel_;
    const float unit_mass_;
    const SpatialTree::Leaf& leaf_;
    const GaussianLoops& loops_ = fastest<GaussianLoops>();
    Eigen::Vector3d centre_;
    Eigen::Vector3f mean_normal_;  // a float, so that sources and targets subtract the same
    bool quick_;
};

}  // namespace

GaussianSums gaussian_sums(const PreparedMesh& mesh, const SpatialTree& tree,
                           const std::vector<Eigen::Vector3d>& normals,
                           const GaussianKernel& kernel, const StageProgress& stage) {
    GaussianSums sums(mesh.size());
    const float unit_mass = mean_mass(mesh);
    const LeafSources<GaussianSource> all(mesh, tree, [&](std::uint32_t v) -> GaussianSource {
        const Eigen::Vector3f n = normals[v].cast<float>();
        return {0, 0, 0, float(mesh.masses[v]) / unit_mass, n.x(), n.y(), n.z(), 0};
    });
    using Sources = std::vector<GaussianSource>;
    parallel_for<Sources>(tree.leaves().size(), stage, [&](std::size_t i, Sources& sources) {
        const SpatialTree::Leaf& leaf = tree.leaves()[i];
        const LeafSum leaf_sum(mesh, normals, kernel, unit_mass, leaf);
        const std::size_t count = leaf_sum.collect(all, sources);
        for (std::uint32_t begin = leaf.begin; begin < leaf.end; begin += kTargets)
            leaf_sum.sum(begin, sources, count, sums);
    });
    return sums;
}

}  // namespace laplacian_lines
