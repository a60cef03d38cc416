// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clusters/extractor_data.h"
#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// The convex crest lines of a surface, whatever the view: where the curvature is largest along
/// the direction in which it is largest. With e₁ that direction, t = tr S, they are the zeros of
/// ∇t·e₁ at which ∇t falls along e₁; ∇t is the tangential part of Δn (Δn = −‖S‖² n + ∇t), so the
/// heat kernel makes them as robust as Laplacian lines. Only where one convex curvature rules,
/// k₁ > 2|k₂|, and the surface turns by at least kLeastRidgeAngle.
struct Ridges {
    /// A point's `gradient` is the angle in degrees by which the surface turns across a kernel,
    /// 2 k₁ √h; its opacity and weight are 1.
    LineSet lines;
    /// What tells how far a point is from a contour, by point.
    struct Form {
        Eigen::Vector3f normal;  ///< n, about unit
        Eigen::Vector3f bend;    ///< k₁ e₁, local
    };
    std::vector<Form> forms;
    std::vector<float> sharpest;  ///< the largest angle of a line's points, by line
};
/// The number of threads does not matter.
Ridges find_ridges(const ExtractorData& data);

constexpr float kLeastRidgeAngle = 5;  // degrees; less is no edge to any eye

}  // namespace laplacian_lines
