// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

#include "field/cubic_form.h"
#include "field/tensor_sums.h"
#include "laplacian_lines/field.h"
#include "mesh/prepared_mesh.h"
#include "mesh/spatial_tree.h"
#include "sums/leaf_sources.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Radius for C, in derivative_kernel(): (1 − d²/R²)² spreads like a kernel of 0.85 √h.
constexpr double kDerivativeReach = 3.4;
/// Radius for S̄, like a kernel of 0.35 √h: keeps visible form, removes noise of a fifth of the
/// edges.
constexpr double kSmoothReach = 1.4;

/// The linear function in a vertex's tangent plane that fits S best, local units.
struct TensorFit {
    bool found = false;     ///< false: too few neighbours, or about on one line
    Eigen::Vector3d value;  ///< at the vertex: S(u,u), S(u,v), S(v,v)
    CubicForm slopes;       ///< made symmetric
};

/// Fits S of the vertices around each vertex, weighted by mass, nearness and how they face.
class TensorFits {
public:
    /// All outlive the object.
    TensorFits(const PreparedMesh& mesh, const SpatialTree& tree, const Field& field);

    /// Calls take(v, fit), on any thread, for each vertex that has a fit within `reach` kernels,
    /// counted as 4.7 mean edges if they are larger; for none if the sums would take too long.
    void for_each(double reach, const StageProgress& stage,
                  const std::function<void(std::uint32_t v, const TensorFit& fit)>& take) const;

private:
    TensorTargets targets(const SpatialTree::Leaf& leaf, double radius, std::uint32_t begin) const;

    const PreparedMesh& mesh_;
    const SpatialTree& tree_;
    const Field& field_;
    const LeafSources<TensorSource> sources_;
};

}  // namespace laplacian_lines
