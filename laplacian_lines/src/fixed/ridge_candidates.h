// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fixed/surface.h"
#include "fixed/zero_lines.h"

namespace laplacian_lines {

/// Least length of the sharp part of a ridge, D; sharper ones may be shorter, see kMostSharpness.
constexpr float kLeastRidgeLength = 0.04f;

/// Ridges or valleys.
struct Crest {
    LineKind kind;
    float sign;  ///< 1: convex; −1: concave, the ridges of the surface turned inside out
};
constexpr Crest kConvexCrest{LineKind::Ridge, 1}, kConcaveCrest{LineKind::Valley, -1};

/// Crest lines of a sort, sharp or not, whatever the view. With e₁ the direction of the largest
/// curvature and t = tr S, they are the zeros of ∇t·e₁ at which ∇t falls along e₁; ∇t is the
/// tangential part of Δn (Δn = −‖S‖² n + ∇t), so the heat kernel makes them as robust as Laplacian
/// lines. Only where k₁ > 2|k₂| and k₁ ≥ 4/D, and only if long enough.
ZeroLines find_ridge_candidates(const ExtractorData& data, Crest crest);

/// Sets the gradient of each point of the candidates to the angle of the edge there, in degrees,
/// see ridge_angles.cpp. The number of threads does not matter.
void measure_ridge_angles(const Surface& surface, Crest crest, ZeroLines& candidates);

}  // namespace laplacian_lines
