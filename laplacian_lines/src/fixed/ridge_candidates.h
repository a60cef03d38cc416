// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "clusters/mesh_sides.h"
#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// Over which a ridge is sharp somewhere, in D; the sharper, the shorter it may be, see
/// SharpLength.
constexpr float kLeastRidgeLength = 0.04f;

/// Convex crest lines, sharp or not, whatever the view. With e₁ the direction of the largest
/// curvature and t = tr S, they are the zeros of ∇t·e₁ at which ∇t falls along e₁; ∇t is the
/// tangential part of Δn (Δn = −‖S‖² n + ∇t), so the heat kernel makes them as robust as Laplacian
/// lines. Only where one convex curvature rules, k₁ > 2|k₂|,
/// and none that is too short however sharp.
struct RidgeCandidates {
    /// What there is at a point of a line, local.
    struct Form {
        Eigen::Vector3f position;
        Eigen::Vector3f normal;  ///< n, about unit
        Eigen::Vector3f bend;    ///< k₁ e₁, of either sign
        MeshSide side;           ///< on which the point lies
    };
    LineSet lines;            ///< opacity and weight are 1, what else is in a point says nothing
    std::vector<Form> forms;  ///< by point
};

/// The number of threads does not matter.
RidgeCandidates find_ridge_candidates(const ExtractorData& data,
                                      const std::vector<PlacedCluster>& placed);

}  // namespace laplacian_lines
