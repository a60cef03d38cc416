// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "laplacian_lines/field.h"

/// Functions whose zeros are lines, vertex by vertex. Sums are in the order of a redraw's inner
/// loops, for equal signs near zero.
namespace reference {

/// Local coordinates.
struct KindVertex {
    Eigen::Vector3f position, normal;
    Eigen::Vector3f curvature;   ///< S̄·D
    Eigen::Vector4f derivative;  ///< C·D²

    /// Of tangents, in the frame of S̄ and C.
    Eigen::Vector2f S(const Eigen::Vector2f& x) const;
    float C(const Eigen::Vector2f& x, const Eigen::Vector2f& y, const Eigen::Vector2f& z) const;
};

/// v·S v, v to the eye (e, w).
float radial(const KindVertex& p, const Eigen::Vector3f& e, float w);

/// Hess I(g, g), g = ∇I, of the light (e, w).
float photic(const KindVertex& p, const Eigen::Vector3f& e, float w);

/// The largest curvature as seen, and its derivative along its direction on the surface.
struct ApparentCurvature {
    float q = 0, derivative = 0;  ///< q: 0 where there is none or the surface faces away
    Eigen::Vector3f direction = Eigen::Vector3f::Zero();
};
ApparentCurvature apparent_curvature(const KindVertex& p, const Eigen::Vector3f& e, float w);

}  // namespace reference
