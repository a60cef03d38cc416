// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/tensor_fits.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "system/large_array.h"
#include "system/parallel.h"
#include "system/simd_sets.h"

namespace laplacian_lines {
namespace {

constexpr double kLargestCurvature = 1e15;  // 1/D; sums of it with squares of lengths stay floats

static_assert(TensorLeaf::kSize == SpatialTree::kLeafSize);

/// Without its place and mass, which depend on the leaf.
TensorSource source_of(const Eigen::Vector3f& n, const ShapeOperator& s, double diagonal) {
    const auto bounded = [&](float x) {
        return float(std::clamp(diagonal * x, -kLargestCurvature, kLargestCurvature));
    };
    return {0,
            0,
            0,
            0,
            {n.x(), n.y(), n.z()},
            bounded(s.xx),
            bounded(s.yy),
            bounded(s.zz),
            bounded(s.yz),
            bounded(s.xz),
            bounded(s.xy)};
}

}  // namespace

TensorSources::TensorSources(const PreparedMesh& mesh, const SpatialTree& tree, const Field& field)
    : tree_(tree), packed_(large_array<TensorLeaf>(tree.leaves().size())) {
    const double mass = sum_of(mesh.size(), [&](std::size_t v) { return mesh.masses[v]; });
    const double per_mass = mass > 0 ? double(mesh.size()) / mass : 0;
    in_parallel(packed_.size(), [&](std::size_t i) {
        const SpatialTree::Leaf& leaf = tree.leaves()[i];
        const Eigen::Vector3d centre = leaf.box.center();
        TensorLeaf& to = packed_[i];
        to.count = leaf.end - leaf.begin;
        for (std::size_t k = 0; k < to.count; ++k) {
            const std::size_t v = leaf.begin + k, original = mesh.original_vertex[v];
            const Eigen::Vector3f p = (mesh.positions[v] - centre).cast<float>();
            TensorSource& source = to.sources[k];
            source =
                source_of(field.normals[original], field.shape_operators[original], mesh.diagonal);
            source.x = to.x[k] = p.x();
            source.y = to.y[k] = p.y();
            source.z = to.z[k] = p.z();
            source.mass = float(mesh.masses[v] * per_mass);
        }
    });
}

std::size_t TensorSources::collect(const SpatialTree::Leaf& leaf, double reach,
                                   std::vector<TensorSource>& sources) const {
    const Eigen::Vector3d centre = leaf.box.center();
    const Eigen::Vector3f half_size = (leaf.box.sizes() / 2).cast<float>();
    std::size_t count = 0;
    tree_.visit_leaves(leaf.box, reach, [&](const SpatialTree::Leaf& other) {
        const TensorLeaf& packed = packed_[std::size_t(&other - tree_.leaves().data())];
        if (sources.size() < count + packed.count + 1)
            sources.resize(2 * (count + TensorLeaf::kSize));
        const Eigen::Vector3f shift = (other.box.center() - centre).cast<float>();
        count += fastest<SlopeLoops>().collect(packed, shift.data(), half_size.data(),
                                               float(reach * reach), &sources[count]);
    });
    return count;
}

}  // namespace laplacian_lines
