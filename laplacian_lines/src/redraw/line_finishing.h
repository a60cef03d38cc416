// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clusters/extractor_data.h"
#include "redraw/hairpins.h"
#include "redraw/strip_tracing.h"

namespace laplacian_lines {

/// What a thread finishes lines in; keeps its memory.
struct FinishingThread {
    Hairpins hairpins;
    std::vector<float> clear;              ///< how clear a line is by itself, by point
    std::vector<std::uint32_t> cut_lines;  ///< first points of lines that hairpins cut
    std::vector<Polyline> cut_parts;       ///< what is left of them
};
using FinishingMemory = std::vector<FinishingThread>;

/// Replaces `lines` by the traced lines: their points in mesh coordinates, tapered and smoothed.
void finish_lines(const ExtractorData& data, const TracedLines& traced, FinishingMemory& memory,
                  LineSet& lines);

}  // namespace laplacian_lines
