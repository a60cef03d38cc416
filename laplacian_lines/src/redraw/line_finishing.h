// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clusters/extractor_data.h"
#include "redraw/strip_tracing.h"
#include "rules/line_parts.h"

namespace laplacian_lines {

/// What a thread finishes lines in; keeps its memory.
struct FinishingThread {
    std::vector<float> columns, part_columns;
    LinePartFinder finder;
    std::vector<LinePoint> points;  ///< of the parts of whole lines
    std::vector<Polyline> parts;    ///< with their places there
};
/// Where the parts of a whole line are.
struct FinishedParts {
    std::uint32_t thread, first, count;
};
struct FinishingMemory {
    std::vector<FinishingThread> threads;
    std::vector<FinishedParts> whole;
};

/// Replaces `lines` by the traced lines and the parts that are drawn of whole ones: their points in
/// mesh coordinates, tapered and smoothed.
void finish_lines(const ExtractorData& data, const TracedLines& traced, FinishingMemory& memory,
                  LineSet& lines);

}  // namespace laplacian_lines
