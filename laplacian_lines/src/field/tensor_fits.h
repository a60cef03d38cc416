// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "field/cubic_form.h"
#include "field/tensor_slopes.h"
#include "laplacian_lines/field.h"
#include "mesh/prepared_mesh.h"
#include "mesh/spatial_tree.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Vertices with their S as sources for SlopeLoops, by leaf.
class TensorSources {
public:
    TensorSources(const PreparedMesh& mesh, const SpatialTree& tree, const Field& field);

    /// Writes what is within `reach` of the leaf's box, relative to the box's centre; returns how
    /// many. `sources` grows as needed.
    std::size_t collect(const SpatialTree::Leaf& leaf, double reach,
                        std::vector<TensorSource>& sources) const;

private:
    const SpatialTree& tree_;
    std::vector<TensorLeaf> packed_;
};

/// √h of C and S̄, mesh units: fits need more vertices than the Laplacian's sums do.
inline double derivative_kernel(const FieldScale& scale) {
    return std::max(scale.kernel_size, 2 * scale.mean_edge);
}

/// In derivative_kernel(), for C: the spread of the weights is that of a kernel of 0.85 √h.
constexpr double kDerivativeReach = 3.4;
/// Reach for C, in mean edges: a larger one is slower, not better. Smaller ones are cut as much.
constexpr double kMostDerivativeReach = 16;
/// For S̄, the spread of a kernel of 0.35 √h: keeps visible form, loses what noise of a fifth of
/// the edges adds.
constexpr double kSmoothReach = 1.4;

/// The linear function in a vertex's tangent plane that fits S best, local units.
struct TensorFit {
    bool found = false;     ///< false: too few neighbours, or not in all directions
    Eigen::Vector3d value;  ///< at the vertex: S(u,u), S(u,v), S(v,v)
    CubicForm slopes;       ///< made symmetric
};

/// Fits S of the vertices around each vertex, weighted by mass, nearness and how they face.
class TensorFits {
public:
    /// Keeps references.
    TensorFits(const PreparedMesh& mesh, const SpatialTree& tree, const Field& field);

    /// Calls take(v, fit), on any thread, for each vertex that has a fit within `reach` kernels;
    /// for none where the sums would take seconds.
    template <class Take>
    void for_each(double reach, const StageProgress& stage, const Take& take) const {
        const std::vector<float> radii = radii_of(reach);
        if (is_endless(radii)) return;
        parallel_for<Scratch>(tree_.leaves().size(), stage, [&](std::size_t i, Scratch& scratch) {
            const SpatialTree::Leaf& leaf = tree_.leaves()[i];
            fit_leaf(leaf, radii, scratch);
            for (std::uint32_t v = leaf.begin; v < leaf.end; ++v)
                if (scratch.fits[v - leaf.begin].found) take(v, scratch.fits[v - leaf.begin]);
        });
    }

private:
    struct Scratch {
        std::vector<TensorSource> sources;
        TensorFit fits[SpatialTree::kLeafSize];
    };

    std::vector<float> radii_of(double reach) const;
    bool is_endless(const std::vector<float>& radii) const;
    void fit_leaf(const SpatialTree::Leaf& leaf, const std::vector<float>& radii,
                  Scratch& scratch) const;
    TensorTargets targets(const SpatialTree::Leaf& leaf, const std::vector<float>& radii,
                          std::uint32_t begin) const;

    const PreparedMesh& mesh_;
    const SpatialTree& tree_;
    const Field& field_;
    const TensorSources sources_;
};

}  // namespace laplacian_lines
