// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <optional>

namespace laplacian_lines {

/// The eye in homogeneous form (e, w), mesh coordinates. The light sits at the eye; the vector to
/// it from a surface point p is l(p) = e − w p. (2e, 2w) is the same view.
struct View {
    Eigen::Vector3d eye = Eigen::Vector3d::UnitZ();
    double w = 0;
    /// Towards a directional light, d, any length; without one the light sits at the eye. Changes
    /// photic extremum lines and Laplacian lines, which are then the zeros of Δn·d, exactly.
    std::optional<Eigen::Vector3d> light = std::nullopt;

    /// A camera at the given position.
    static View perspective(const Eigen::Vector3d& position) { return {position, 1}; }
    /// A camera infinitely far away; `towards_viewer` may have any length.
    static View orthographic(const Eigen::Vector3d& towards_viewer) { return {towards_viewer, 0}; }
};

/// By how much lengths grow: the cube root of the factor of volumes.
inline double mean_scale(const Eigen::Matrix4d& transform) {
    return std::cbrt(std::abs(transform.topLeftCorner<3, 3>().determinant()));
}

}  // namespace laplacian_lines
