// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <sstream>
#include <string>
#include <vector>

#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/view.h"

/// Views in which edges of boxes fall on each other and faces are seen edge-on, so that rounding
/// would decide what is seen.
namespace tie_views {

using laplacian_lines::LineKind;
using laplacian_lines::View;

inline laplacian_lines::LineKindSet edge_kinds() {
    return laplacian_lines::only_kinds({LineKind::Contour, LineKind::Border, LineKind::Crease});
}

/// Exactly towards the 26 faces, edges and corners of a cube, and a few arbitrary ones.
inline std::vector<Eigen::Vector3d> special_directions() {
    std::vector<Eigen::Vector3d> directions = {
        {0.31, -0.74, 0.59}, {-0.45, -0.68, 0.35}, {0.93, 0.11, -0.27}, {-0.02, 0.37, 1}};
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0) directions.emplace_back(x, y, z);
    return directions;
}

/// Orthographic and from twice the diagonal.
inline std::vector<View> views_from(const std::vector<Eigen::Vector3d>& directions,
                                    const Eigen::Vector3d& centre, double diagonal) {
    std::vector<View> views;
    for (const Eigen::Vector3d& d : directions) {
        views.push_back(View::orthographic(d));
        views.push_back(View::perspective(centre + 2 * diagonal * d.normalized()));
    }
    return views;
}

inline std::string words(const View& view) {
    std::ostringstream out;
    out.precision(17);
    out << "eye " << view.eye.transpose() << ", w " << view.w;
    return out.str();
}

}  // namespace tie_views
