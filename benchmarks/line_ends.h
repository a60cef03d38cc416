// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_set.h"
#include "laplacian_lines/view.h"

namespace benchmarks {

/// What the ends of contours that are seen are.
struct LineEnds {
    int all = 0;
    int crossings = 0;  ///< at an outline that is nearer to the eye: T-junctions
    int cusps = 0;      ///< the contour's course in the picture turns back
    int meetings = 0;   ///< where the contour itself ends, at the end of another or at a border
    /// The others.
    int loose() const { return all - crossings - cusps - meetings; }

    LineEnds& operator+=(const LineEnds& other);
};

/// `seen` are parts of the lines `whole`; the view is orthographic. What is within `reach` in the
/// picture is at the same place, what is farther than it in depth is at another.
LineEnds ends_of_contours(const laplacian_lines::LineSet& whole,
                          const laplacian_lines::LineSet& seen, const laplacian_lines::View& view,
                          double reach);

}  // namespace benchmarks
