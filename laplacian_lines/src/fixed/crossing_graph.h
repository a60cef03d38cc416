// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace laplacian_lines {

/// A point of a line: a zero on an edge of the mesh, or a vertex.
struct Crossing {
    Eigen::Vector3f position;  ///< local
    float gradient;            ///< as LinePoint::gradient
};

/// A piece of a line from one crossing to another. On consistently oriented triangles the end of
/// one is the begin of the next.
struct Segment {
    std::uint32_t begin, end;  ///< crossings
};

/// Lines of which only the pieces are known, in no order; those that are found once for all views
/// and those along edges of the mesh.
struct CrossingGraph {
    std::vector<Crossing> crossings;
    std::vector<Segment> segments;
};

/// Where half `half % 2` of segment `half / 2` begins.
inline std::uint32_t crossing_at(const CrossingGraph& graph, std::uint32_t half) {
    const Segment& s = graph.segments[half / 2];
    return half % 2 == 0 ? s.begin : s.end;
}

}  // namespace laplacian_lines
