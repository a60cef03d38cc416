// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/box_tree.h"
#include "visibility/visibility_mesh.h"

namespace laplacian_lines {

/// Finds vertices of a mesh, which outlives this, by position.
class VertexLookup {
public:
    /// Holds the vertices for which is_wanted(vertex).
    template <class IsWanted>
    VertexLookup(const VisibilityMesh& mesh, IsWanted is_wanted)
        : positions_(mesh.positions), step_(1 / std::sqrt(double(positions_.size()))) {
        tree_ = BoxTree<3>::along_curve(
            numbers_where(positions_.size(), is_wanted), local_box(), [&](std::uint32_t v) {
                return Eigen::AlignedBox3f(positions_[v].cast<float>().eval());
            });
    }

    /// Calls visit(vertex) for all vertices within `reach` of a straight line and some farther off,
    /// for some more than once.
    template <class Visit>
    void visit_along(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double reach,
                     Visit visit) const {
        const double pieces = std::max(1., std::ceil((to - from).norm() / step_));
        for (double i = 0; i < pieces; ++i) {
            const auto box = box_around(from + i / pieces * (to - from),
                                        from + (i + 1) / pieces * (to - from), reach);
            tree_.visit(box, visit);
        }
    }

private:
    const std::vector<Eigen::Vector3d>& positions_;
    double step_;  // about as far apart as vertices of a surface: long boxes would hold many
    BoxTree<3> tree_;
};

}  // namespace laplacian_lines
