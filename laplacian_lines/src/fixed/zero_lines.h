// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "fixed/triangle_graph.h"
#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// Lines of zeros of a function of the surface, whatever the view.
struct ZeroLines {
    /// What there is at a point of a line, local.
    struct Form {
        Eigen::Vector3f position;
        Eigen::Vector3f normal;  ///< n, about unit
        Eigen::Vector3f bend;    ///< the larger curvature times its direction, of either sign
        TriangleSide side;       ///< on which the point lies
        float value;             ///< what the kind of lines measures there, if anything
    };
    LineSet lines;            ///< opacity and weight are 1, what else is in a point says nothing
    std::vector<Form> forms;  ///< by point
};

/// A zero on an edge between two vertices of the mesh.
struct Zero {
    std::uint64_t edge;  ///< edge_key()
    ZeroLines::Form form;
};

/// `a` is the smaller number of a vertex in the mesh.
inline std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t(a) << 32 | b;
}

/// A piece of a line in a triangle.
struct ZeroPiece {
    Zero ends[2];
};
using ZeroPieces = std::vector<ZeroPiece>;

/// Joins pieces to lines of at least this length, in D. `pieces`: in the order of the clusters.
ZeroLines trace_zeros(const ExtractorData& data, LineKind kind, float least_length,
                      const std::vector<ZeroPieces>& pieces);

}  // namespace laplacian_lines
