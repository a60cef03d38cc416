// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/line_visibility.h"
#include "visibility/sight_pieces.h"

namespace laplacian_lines {

/// Joins the pieces of edges of the mesh to lines. Outlines first, where pieces meet in the same
/// nodes: these lines are closed, and nothing that follows takes of them.
void trace_edges(const SightSegments& all, const std::vector<SightPiece>& pieces,
                 const SightOptions& options, std::vector<SightLine>& traced);

/// Joins the pieces of lines on the surface that are seen. Gaps of less than .1 % of D and parts of
/// less than .3 % do not count.
void trace_surface_lines(const SightSegments& all, const std::vector<SightPiece>& pieces,
                         const std::vector<LineSet>& lines, const SightOptions& options,
                         std::vector<SightLine>& traced);

/// Passes of binomial smoothing, as of smooth_positions(): exact points and open ends stay.
void smooth_between_exact(int passes, SightLine& line);

}  // namespace laplacian_lines
