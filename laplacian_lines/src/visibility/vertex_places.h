// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/box_tree.h"
#include "visibility/sight_mesh.h"

namespace laplacian_lines {

/// Vertices of a mesh by place.
class VertexPlaces {
public:
    /// Holds the vertices that are `wanted`.
    VertexPlaces(const SightMesh& mesh, const std::vector<bool>& wanted)
        : step_(1 / std::sqrt(double(mesh.positions.size()))) {
        std::vector<std::uint32_t> vertices;
        for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
            if (wanted[v]) vertices.push_back(v);
        tree_ = BoxTree<3>::along_curve(std::move(vertices), local_box(), [&](std::uint32_t v) {
            return Eigen::AlignedBox3f(mesh.positions[v].cast<float>().eval());
        });
    }

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
