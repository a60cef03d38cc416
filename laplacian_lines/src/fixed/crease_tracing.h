// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fixed/crease_edges.h"
#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// The creases that a style's angle leaves, joined to lines.
struct TracedCreases {
    float least_angle;  ///< of the style
    LineSet lines;      ///< points in mesh coordinates; gradient: the larger angle of the edges
    /// Which edge goes on from a point to the next one of its line, by point; none from the last.
    std::vector<const CreaseEdge*> edges;
    /// What belongs together: all lines that are connected with a line, or a line with a loose end
    /// alone, by line.
    struct Net {
        std::uint32_t pieces = 0;  ///< straight ones, of one edge or several
        float length = 0;          ///< D
        /// Loose ends, and turns of more than 60 degrees where no third edge meets: where
        /// an edge of the form turns, so do its walls, and there is an edge between these.
        std::uint32_t faults = 0;
    };
    std::vector<Net> nets;
};

/// Joins the edges that a style with this crease angle shows to lines, which end where other than
/// two of them meet. The edges must outlive the result.
TracedCreases trace_creases(const ExtractorData& data, const std::vector<CreaseEdge>& edges,
                            float least_angle);

}  // namespace laplacian_lines
