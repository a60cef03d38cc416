// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

constexpr int kEyes = 24;
constexpr double kOrbitRadius = 1.25;  // in D

/// Views from around a mesh, a little from above.
inline std::vector<laplacian_lines::View> orbit(const laplacian_lines::TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : mesh.positions)
        if (p.allFinite()) box.extend(p);
    std::vector<laplacian_lines::View> views;
    for (int i = 0; i < kEyes; ++i) {
        const double angle = 2 * std::acos(-1.0) * i / kEyes;
        const Eigen::Vector3d direction(std::cos(angle), 0.4, std::sin(angle));
        views.push_back(laplacian_lines::View::perspective(
            box.center() + kOrbitRadius * box.diagonal().norm() * direction.normalized()));
    }
    return views;
}
