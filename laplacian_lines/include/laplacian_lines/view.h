// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

namespace laplacian_lines {

/// The eye in homogeneous form (e, w), in mesh coordinates. The vector from a surface point p to
/// the light, which sits at the eye, is l(p) = e − w p. No scale is attached: (2e, 2w) is the same
/// view.
struct View {
    Eigen::Vector3d eye = Eigen::Vector3d::UnitZ();
    double w = 0;
    /// Towards a directional light, in mesh coordinates, any length. Without one the light sits at
    /// the eye. Only Laplacian lines change: they are then the zeros of Δn·d, which is exact.
    std::optional<Eigen::Vector3d> light = std::nullopt;

    /// A camera at the given position.
    static View perspective(const Eigen::Vector3d& position) { return {position, 1}; }
    /// A camera infinitely far away; `towards_viewer` points from the object to it, any length.
    static View orthographic(const Eigen::Vector3d& towards_viewer) { return {towards_viewer, 0}; }
};

}  // namespace laplacian_lines
