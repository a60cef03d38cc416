// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "laplacian_lines/line_set.h"
#include "laplacian_lines/triangle_mesh.h"

namespace helpers {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Every pair of a set's points has to be an edge.
inline std::multiset<Edge> edges_of(const laplacian_lines::TriangleMesh& mesh,
                                    const laplacian_lines::LineSet& lines) {
    std::map<std::array<float, 3>, std::uint32_t> vertex;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        const Eigen::Vector3f p = mesh.positions[v].cast<float>();
        vertex[{p.x(), p.y(), p.z()}] = v;
    }
    const auto find = [&](const Eigen::Vector3f& p) -> std::uint32_t {
        for (const auto& [q, v] : vertex)
            if ((p - Eigen::Vector3f(q[0], q[1], q[2])).norm() < 1e-5) return v;
        ADD_FAILURE() << "a point that is not a vertex";
        return 0;
    };
    std::multiset<Edge> edges;
    for (const laplacian_lines::Polyline& line : lines.lines)
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i)
            edges.insert(
                std::minmax(find(lines.points[i - 1].position), find(lines.points[i].position)));
    return edges;
}

}  // namespace helpers
