// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fixed/surface.h"
#include "fixed/zero_lines.h"

namespace laplacian_lines {

/// Over which a ridge is sharp somewhere, in D; the sharper, the shorter it may be, see
/// kMostSharpness.
constexpr float kLeastRidgeLength = 0.04f;

/// On which side of the surface an edge is one.
struct Crest {
    LineKind kind;
    float sign;  ///< 1: convex; −1: concave, the convex ones of the surface turned inside out
};
constexpr Crest kConvexCrest{LineKind::Ridge, 1}, kConcaveCrest{LineKind::Valley, -1};

/// Convex crest lines, sharp or not, whatever the view. With e₁ the direction of the largest
/// curvature and t = tr S, they are the zeros of ∇t·e₁ at which ∇t falls along e₁; ∇t is the
/// tangential part of Δn (Δn = −‖S‖² n + ∇t), so the heat kernel makes them as robust as Laplacian
/// lines. Only where one convex curvature rules, k₁ > 2|k₂|,
/// and none that is too short however sharp.
using RidgeCandidates = ZeroLines;

RidgeCandidates find_ridge_candidates(const ExtractorData& data, Crest crest);

/// Makes the gradient of each point of the candidates the angle of the edge there, in degrees, and
/// moves the points to its middle. The angle is that by which the surface turns across the line
/// within 2 % of D to both sides, in the mean along 1.5 % of the line, whatever the triangles' and
/// the kernel's size; less, down to 0, where the surface goes on turning as fast beyond, as a bump
/// does, or turns on one side only. The number of threads does not matter.
void measure_ridge_angles(const ExtractorData& data, const Surface& surface, Crest crest,
                          RidgeCandidates& candidates);

}  // namespace laplacian_lines
