// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/line_visibility.h"
#include "visibility/visibility_segments.h"

namespace laplacian_lines {

/// Of two segments in the picture.
struct PictureCrossing {
    std::uint32_t segments[2];
    double shares[2];  ///< of the length of each, in the picture
};

/// All crossings of segments of which one divides. Lines on the surface are crossed only by
/// segments in front of them; two segments with surface on both sides cross only where they meet in
/// space. The orientations of the four ends decide, and are computed in one way everywhere: a chain
/// that passes over another crosses it once, also at a vertex. The order does not depend on
/// threads.
std::vector<PictureCrossing> find_crossings(const VisibilitySegments& all);

/// A part of a segment between neighbouring crossings or ends: visibility is constant along it.
struct VisibilityPiece {
    std::uint32_t segment;
    /// Numbers of points of the segments, then of crossings.
    std::uint32_t nodes[2];
    double shares[2];  ///< of the length of the segment, in the picture
    bool is_hidden;
    bool is_outline;  ///< visible, with nothing on one side
    float gap;        ///< of seen edges to the surface behind, local; infinite if there is none
};

/// The pieces of all segments that are drawn, in order, decided by rays through their middles; only
/// one for those of a line on the surface that no crossing parts. @throws Error(Cancelled)
std::vector<VisibilityPiece> find_visibility_pieces(const VisibilitySegments& all,
                                                    const std::vector<PictureCrossing>& crossings,
                                                    const StageProgress& stage);

/// Joins pieces to lines at common nodes: mesh edges, outlines so that they close; then the visible
/// parts of lines on the surface.
std::vector<ViewLine> trace_lines(const VisibilitySegments& all,
                                  const std::vector<VisibilityPiece>& pieces,
                                  const VisibilityOptions& options);

}  // namespace laplacian_lines
