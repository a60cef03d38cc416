// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "speed_report.h"

namespace benchmarks {

/// Sections of the paper's table that others have figures for; keys are those of kinds.
extern const Section kRedraw;      ///< ms
extern const Section kToContours;  ///< over the same method's contours

/// Columns to stand beside ours: from the table of the paper (drawing included, hardware of 2009)
/// the least and the largest ratios, and what Princeton's rtsc took as shipped, which draws no
/// traced lines, on one thread of a machine like that of docs/performance.md.
std::vector<MeshFigures> published_figures();
extern const char* const kPublishedNote;

}  // namespace benchmarks
