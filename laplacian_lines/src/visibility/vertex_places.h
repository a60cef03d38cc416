// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/box_tree.h"
#include "visibility/sight_mesh.h"

namespace laplacian_lines {

/// Those that edges have, by vertex.
std::vector<bool> vertices_of_edges(const SightMesh& mesh);

/// Vertices of a mesh by place.
class VertexPlaces {
public:
    /// Holds the vertices that are `wanted`.
    VertexPlaces(const SightMesh& mesh, const std::vector<bool>& wanted);

    /// Calls visit(vertex) for all vertices within `reach` of a straight line, some of them more
    /// than once.
    template <class Visit>
    void visit_along(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double reach,
                     Visit visit) const {
        const double pieces = std::max(1., std::ceil((to - from).norm() / step_));
        for (double i = 0; i < pieces; ++i) {
            const auto box = box_around(from + i / pieces * (to - from),
                                        from + (i + 1) / pieces * (to - from), reach);
            tree_.visit(box, [&](std::uint32_t vertex) {
                visit(vertex);
                return true;
            });
        }
    }

private:
    double step_;
    BoxTree<3> tree_;
};

}  // namespace laplacian_lines
