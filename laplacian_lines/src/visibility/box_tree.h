// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>
#include <vector>

#include "system/parallel.h"

namespace laplacian_lines {

/// A tree of boxes around numbered objects: Eigen's trees of parts of them, which threads build
/// side by side, under one of these parts.
class BoxTree {
public:
    using Box = Eigen::AlignedBox3d;

    BoxTree() = default;
    /// Around the objects 0, 1, ...; each box has to be finite. @throws Error(Cancelled)
    BoxTree(const std::vector<Box>& boxes, const StageProgress& stage);

    /// Visits objects as Eigen::BVIntersect() does: query.intersectVolume(box) says whether to look
    /// into a box, query.intersectObject(number) whether to stop.
    template <class Query>
    void visit(Query& query) const {
        PartsQuery<Query> parts = {parts_, {query}};
        Eigen::BVIntersect(tree_of_parts_, parts);
    }

private:
    using Tree = Eigen::KdBVH<double, 3, int>;

    template <class Query>
    struct PartQuery {
        bool intersectVolume(const Box& box) const { return query.intersectVolume(box); }
        bool intersectObject(int object) { return stops = query.intersectObject(object); }

        Query& query;
        bool stops = false;
    };
    template <class Query>
    struct PartsQuery {
        bool intersectVolume(const Box& box) const { return in_part.intersectVolume(box); }
        bool intersectObject(int part) {
            Eigen::BVIntersect(parts[std::size_t(part)], in_part);
            return in_part.stops;
        }

        const std::vector<Tree>& parts;
        PartQuery<Query> in_part;
    };

    std::vector<Tree> parts_;
    Tree tree_of_parts_;
};

}  // namespace laplacian_lines
