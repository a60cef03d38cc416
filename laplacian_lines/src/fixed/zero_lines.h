// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "clusters/extractor_data.h"
#include "laplacian_lines/line_set.h"
#include "system/parallel.h"
#include "system/three_floats.h"

namespace laplacian_lines {

/// Lines of zeros of a function of the surface, whatever the view.
struct ZeroLines {
    /// The surface at a point of a line, local.
    struct Sample {
        Eigen::Vector3f position;
        Eigen::Vector3f normal;  ///< n, about unit
        Eigen::Vector3f bend;    ///< S e, of the unit direction e across the line, of either sign
        std::uint32_t side;      ///< of Surface, on which the point lies
        float value;             ///< what the kind of lines measures there, if anything
        float triangle;          ///< of the triangles there: the least of their longest sides,
        float height;            ///< and the largest of their least heights
    };
    LineSet lines;                ///< opacity and weight are 1, gradients 0
    std::vector<Sample> samples;  ///< by point
};

/// A zero on an edge between two vertices of the mesh.
struct Zero {
    std::uint64_t edge;
    ZeroLines::Sample sample;
};

/// In a triangle, between zeros on two of its sides.
using ZeroPiece = std::array<Zero, 2>;
using ZeroPieces = std::vector<ZeroPiece>;

/// Values at one end of an edge, between which a zero is interpolated.
struct ZeroEnd {
    float function;        ///< whose zero it is
    Eigen::Vector3f bend;  ///< as ZeroLines::Sample has it
    float value;
};

/// The piece in a triangle of a cluster in which the function changes its sign. `ends(a, b)` is a
/// pair of ZeroEnd for two vertices of the cluster.
template <class Ends>
ZeroPiece zero_piece(const PlacedCluster& placed, unsigned triangle, const bool is_negative[3],
                     const Ends& ends) {
    const auto& corners = placed.triangle(triangle).corners;
    const Eigen::Vector3f p = position_of(placed.records[corners[0]]),
                          to_second = position_of(placed.records[corners[1]]) - p,
                          to_third = position_of(placed.records[corners[2]]) - p;
    const float longest =
        std::max({length_of(to_second), length_of(to_third), length_of(to_third - to_second)});
    const float height = longest > 0 ? length_of(to_second.cross(to_third)) / longest : 0;
    ZeroPiece piece{};
    std::size_t found = 0;
    for (unsigned k = 0; k < 3; ++k) {
        if (is_negative[k] == is_negative[(k + 1) % 3]) continue;
        // in this order, so that the triangles on both sides name the edge alike
        unsigned a = corners[k], b = corners[(k + 1) % 3];
        if (placed.vertices[b] < placed.vertices[a]) std::swap(a, b);
        const std::pair<ZeroEnd, ZeroEnd> of = ends(a, b);
        // Opposite signs by is_negative, whatever these functions say: that of a crest takes its
        // sign from a direction of either sign. They are not both 0.
        const float fa = std::abs(of.first.function);
        const float t = fa / (fa + std::abs(of.second.function));
        const VertexRecord &first = placed.records[a], &second = placed.records[b];
        piece[found++] = {std::uint64_t(placed.vertices[a]) << 32 | placed.vertices[b],
                          {(1 - t) * position_of(first) + t * position_of(second),
                           (1 - t) * normal_of(first) + t * normal_of(second),
                           (1 - t) * of.first.bend + t * of.second.bend,
                           3 * (placed.first_triangle + triangle) + k,
                           (1 - t) * of.first.value + t * of.second.value, longest, height}};
    }
    return piece;
}

/// Joins pieces to lines of at least this length, in D. `pieces`: in the order of the clusters.
ZeroLines trace_zeros(const ExtractorData& data, LineKind kind, float least_length,
                      const std::vector<ZeroPieces>& pieces);

/// Joins the pieces in all clusters. ClusterZeros(placed, more...) has add(triangle, pieces), which
/// appends the one in a triangle, if any; it is not called for FaceShape::Enclosed, whose edges
/// show its form. Any number of threads gives the same.
template <class ClusterZeros, class... More>
ZeroLines find_zero_lines(const ExtractorData& data, LineKind kind, float least_length,
                          const More&... more) {
    const std::vector<PlacedCluster> placed = place_clusters(data);
    std::vector<ZeroPieces> pieces(placed.size());
    in_parallel(placed.size(), [&](std::size_t c) {
        const ClusterZeros cluster(placed[c], more...);
        for (unsigned t = 0; t < placed[c].cluster->triangle_count; ++t)
            if (!placed[c].is_enclosed(t)) cluster.add(t, pieces[c]);
    });
    return trace_zeros(data, kind, least_length, pieces);
}

}  // namespace laplacian_lines
