// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// The box of the points point_of(i), 0 <= i < count; empty if there are none.
template <class PointOf>
Eigen::AlignedBox3d bounding_box(std::size_t count, PointOf point_of) {
    const auto of_block = [&](std::size_t begin, std::size_t end) {
        Eigen::AlignedBox3d box;
        for (std::size_t i = begin; i < end; ++i)
            box.extend(point_of(i));
        return box;
    };
    return join_blocks(
        count, Eigen::AlignedBox3d(), of_block,
        [](const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) { return a.merged(b); });
}

inline Eigen::AlignedBox3d bounding_box(const std::vector<Eigen::Vector3d>& points) {
    return bounding_box(points.size(),
                        [&](std::size_t i) -> const Eigen::Vector3d& { return points[i]; });
}

/// Of the corners of triangles.
inline Eigen::AlignedBox3d bounding_box(const std::vector<Eigen::Vector3d>& positions,
                                        const std::vector<Triangle>& triangles) {
    return bounding_box(3 * triangles.size(), [&](std::size_t corner) -> const Eigen::Vector3d& {
        return positions[triangles[corner / 3][corner % 3]];
    });
}

/// The largest absolute coordinate, by axis.
inline Eigen::Vector3d largest_coordinates(const Eigen::AlignedBox3d& box) {
    return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
}

}  // namespace laplacian_lines
