// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/drawn_view.h"

namespace line_drawing {

/// The area that loops enclose (even-odd), for many queries.
class WallArea {
public:
    explicit WallArea(const Wall& loops);

    bool contains(const Eigen::Vector2d& point) const;

    /// A part of a segment, from one share of it to another.
    struct Stretch {
        double begin, end;
    };
    /// The maximal stretches of a segment that are outside, or along a loop; in their order.
    std::vector<Stretch> outside(const Eigen::Vector2d& begin, const Eigen::Vector2d& end) const;

private:
    struct Edge {
        Eigen::Vector2d begin, end;
    };
    std::size_t row_of(double y) const;
    std::vector<double> crossings(const Eigen::Vector2d& begin, const Eigen::Vector2d& end) const;
    bool encloses(const Eigen::Vector2d& begin, const Eigen::Vector2d& end) const;

    double low_ = 0, row_height_ = 1;      // of the rows, along y
    double slight_ = 0;                    // distance to either side of a line along a border
    std::vector<std::vector<Edge>> rows_;  // the edges that pass through each
};

/// The parts of lines that the area does not cover.
std::vector<DrawnLine> without_parts_in(const WallArea& area, const std::vector<DrawnLine>& lines);

/// An object's wall and the lines around it, where a plane cuts it.
struct CutObject {
    Wall wall = {};
    std::vector<DrawnLine> lines = {};
};

/// Adds walls and lines to a view. Walls that overlap are merged: their lines end where they enter
/// another. Walls that touch, or overlap as little as scans of fitting parts, stay separate.
void add_walls(std::vector<CutObject> objects, DrawnView& drawn);

}  // namespace line_drawing
