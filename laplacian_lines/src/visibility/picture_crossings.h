// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/line_set.h"
#include "laplacian_lines/view.h"
#include "visibility/box_tree.h"
#include "visibility/line_parts.h"

namespace laplacian_lines {

/// Where a line passes behind an outline in the picture, and so may go out of sight or come into
/// it.
struct Passage {
    LinePlace place;
    bool may_hide = true, may_show = true;  ///< on the way along the line
    double distance = 0;                    ///< of the outline before it
};

/// Outlines of one view as they lie in the picture.
class PictureCrossings {
public:
    /// `free_sides` has a sign for each line: of a contour, on which side of it its own surface is
    /// not; 0 if that is not known, as of borders.
    PictureCrossings(const LineSet& lines, const View& view, const std::vector<int>& free_sides,
                     double diagonal);

    /// Whether crossings are known: not where the eye is among the lines.
    bool are_known() const { return are_known_; }

    /// Those of one of the lines, in its order. Thread-safe.
    std::vector<Passage> along(const Polyline& line) const;

private:
    struct Outline {
        std::uint32_t point;  ///< its segment begins here
        int free_side;
    };
    class Query;

    /// At a share of the way from a point to the next one in the picture.
    double depth(std::uint32_t point, double t) const;
    /// The same share in space.
    double share(std::uint32_t point, double t) const;

    std::vector<Eigen::Vector2d> places_;  ///< in the picture, by point
    std::vector<double> depths_;           ///< away from the eye
    std::vector<Outline> outlines_;
    BoxTree tree_;
    bool are_known_ = false, has_perspective_;
    double nearer_;
};

}  // namespace laplacian_lines
