// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "plain_extraction.h"
#include "rules/line_parts.h"

namespace reference {

/// A line before its parts are found: a segment between each two points.
struct PlainChain {
    struct Segment {
        laplacian_lines::LinePiece sums;
        std::uint32_t cluster;
        bool forward;  ///< the positive side is on the left
    };
    std::vector<laplacian_lines::LinePoint> points;  ///< local; closed: the first again at the end
    std::vector<Segment> segments;
    bool closed;
};

/// Appends the parts that are drawn, finished. What means along lines say is tested by itself; here
/// is what a redraw makes of it: pieces of four segments at most, that end where clusters do.
void add_parts(const laplacian_lines::LineRules& rules, const PlainChain& chain,
               const Eigen::Vector3d& centre, double diagonal, std::vector<PlainLine>& lines);

}  // namespace reference
