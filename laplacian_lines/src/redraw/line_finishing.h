// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clusters/extractor_data.h"
#include "redraw/strip_tracing.h"

namespace laplacian_lines {

/// What each thread finishes lines in; keeps its memory.
using FinishingMemory = std::vector<std::vector<float>>;

/// Replaces `lines` by the traced lines: their points in mesh coordinates, tapered and smoothed.
void finish_lines(const ExtractorData& data, const TracedLines& traced, FinishingMemory& memory,
                  LineSet& lines);

}  // namespace laplacian_lines
