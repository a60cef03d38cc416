// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <utility>

#include "laplacian_lines/triangle_mesh.h"

namespace helpers {

/// Directed edges that occur twice or lack their opposite: 0 for closed, oriented meshes.
inline std::size_t edges_without_partner(const laplacian_lines::TriangleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> times;
    for (const laplacian_lines::Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            ++times[{t[k], t[(k + 1) % 3]}];
    std::size_t count = 0;
    for (const auto& [edge, found] : times)
        count += found != 1 || times.count({edge.second, edge.first}) == 0;
    return count;
}

/// Positive if the triangles of a closed mesh face outwards.
inline double volume(const laplacian_lines::TriangleMesh& mesh) {
    double sum = 0;
    for (const laplacian_lines::Triangle& t : mesh.triangles)
        sum += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])) / 6;
    return sum;
}

}  // namespace helpers
