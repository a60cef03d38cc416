// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_set.h"
#include "laplacian_lines/line_style.h"
#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"
#include "rules/line_parts.h"
#include "rules/line_rules.h"

/// LineExtractor's reference: one loop over all triangles, crossings and chains by maps.

namespace reference {

struct PlainLine {
    std::vector<laplacian_lines::LinePoint> points;
    laplacian_lines::Polyline polyline;
    bool uncertain;  ///< a sum is so near to its threshold that rounding decides
};

/// Includes lines of uncertain acceptance.
std::vector<PlainLine> extract_plainly(const laplacian_lines::TriangleMesh& mesh,
                                       const laplacian_lines::Field& field,
                                       const laplacian_lines::View& view,
                                       const laplacian_lines::LineStyle& style);

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

/// Appends the drawn parts, finished, in a redraw's pieces of at most four segments that end where
/// clusters do. Means along lines have tests of their own.
void add_parts(const laplacian_lines::LineRules& rules, const PlainChain& chain,
               const Eigen::Vector3d& centre, double diagonal, std::vector<PlainLine>& lines);

/// Weights, opacities and smoothed positions, point by point and pass by pass. On entry weights
/// hold the sums of slopes at a point, opacities the fading of its crossing, and positions are
/// local; on return these are mesh coordinates.
void finish_plainly(const laplacian_lines::LineRules& rules, const laplacian_lines::Polyline& line,
                    const Eigen::Vector3d& centre, double diagonal,
                    laplacian_lines::LinePoint* points);

}  // namespace reference
