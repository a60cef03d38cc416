// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "clusters/extractor_data.h"
#include "fixed/crossing_graph.h"
#include "laplacian_lines/line_set.h"
#include "rules/line_rules.h"

namespace laplacian_lines {

/// Memory of trace_segments(); keeps its capacity.
struct TracingMemory {
    /// A half is an end of a segment: 2·segment for its begin, 2·segment + 1 for its end.
    std::vector<std::uint32_t> linked_half;  ///< the half that continues, by half
    std::vector<std::uint32_t> half_of_crossing;
    std::vector<std::uint8_t> degree;   ///< halves at a crossing, saturating at 3
    std::vector<std::uint8_t> visited;  ///< by segment
};

/// Fills `linked_half`: ends of segments that continue each other, where exactly two meet.
void link_halves(const CrossingGraph& graph, TracingMemory& memory);

/// Joins segments to lines and appends those that the rules on whole lines accept (Zhang, He, Seah,
/// step 3 and Eq. 4). On any graph: lines end at crossings where other than two segments meet, such
/// as borders and non-manifold edges.
void trace_segments(const ExtractorData& data, const LineRules& rules, const CrossingGraph& graph,
                    TracingMemory& memory, LineSet& lines);

}  // namespace laplacian_lines
