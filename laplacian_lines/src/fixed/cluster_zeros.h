// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <utility>

#include "fixed/zero_lines.h"

namespace laplacian_lines {

/// What there is at one end of an edge, from which a zero between its ends is made.
struct ZeroEnd {
    float function;        ///< whose zero it is
    Eigen::Vector3f bend;  ///< as ZeroLines::Form has them
    float value;
};

/// Makes pieces of lines in the triangles of one cluster.
class ClusterZeros {
public:
    /// `placed` is kept by reference.
    explicit ClusterZeros(const PlacedCluster& placed) : placed_(placed) {}

    /// The piece in a triangle at some corners of which, not at all, the function is negative.
    /// `ends(a, b)` is a pair of ZeroEnd for two vertices of the cluster.
    template <class Ends>
    ZeroPiece piece(unsigned triangle, const bool is_negative[3], const Ends& ends) const {
        ZeroPiece piece{};
        int found = 0;
        for (int k = 0; k < 3; ++k)
            if (is_negative[k] != is_negative[(k + 1) % 3])
                piece.ends[found++] = zero(triangle, k, ends);
        return piece;
    }

private:
    /// On a side of a triangle; the same, but for the side, from the triangles on both sides.
    template <class Ends>
    Zero zero(unsigned triangle, int side, const Ends& ends) const {
        const auto& corners = placed_.triangle(triangle).corners;
        unsigned a = corners[side], b = corners[(side + 1) % 3];
        if (placed_.vertices[b] < placed_.vertices[a]) std::swap(a, b);
        const std::pair<ZeroEnd, ZeroEnd> of = ends(a, b);
        const float fa = std::abs(of.first.function), sum = fa + std::abs(of.second.function);
        const float t = sum > 0 ? fa / sum : 0.5f;
        const VertexRecord &p = placed_.records[a], &q = placed_.records[b];
        return {edge_key(placed_.vertices[a], placed_.vertices[b]),
                {(1 - t) * position_of(p) + t * position_of(q),
                 (1 - t) * normal_of(p) + t * normal_of(q),
                 (1 - t) * of.first.bend + t * of.second.bend,
                 {placed_.first_triangle + triangle, unsigned(side)},
                 (1 - t) * of.first.value + t * of.second.value}};
    }

    const PlacedCluster& placed_;
};

}  // namespace laplacian_lines
