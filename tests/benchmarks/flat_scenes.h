// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/line_set.h"
#include "picture_camera.h"

/// Small scenes whose pixels can be counted by hand.
namespace flat_scenes {

constexpr int kSize = 100;

/// Two triangles that face +z; [−1, 1]² at z = 0 by default.
inline laplacian_lines::TriangleMesh square(double half = 1, double z = 0) {
    return {{{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}},
            {{0, 1, 2}, {0, 2, 3}}};
}

/// From above: of what spans [−1, 1]², the pixels 10 to 89 of 100; y = 1 is the upper side.
inline benchmarks::PictureCamera from_above(const laplacian_lines::TriangleMesh& mesh) {
    return {laplacian_lines::View::orthographic({0, 0, 1}), mesh, kSize};
}

/// A line of full ink, all of it seen.
inline laplacian_lines::LineSet line(const std::vector<Eigen::Vector3f>& points) {
    laplacian_lines::LineSet lines;
    lines.lines.push_back({0, std::uint32_t(points.size()), laplacian_lines::LineKind::Contour});
    for (const Eigen::Vector3f& p : points)
        lines.points.push_back({p, 1, 0, 1});
    return lines;
}

}  // namespace flat_scenes
