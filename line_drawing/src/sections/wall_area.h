// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/drawn_view.h"

namespace line_drawing {

/// What loops enclose (even-odd), to be asked often.
class WallArea {
public:
    explicit WallArea(const Wall& loops);

    bool contains(const Eigen::Vector2d& point) const;

private:
    struct Edge {
        Eigen::Vector2d begin, end;
    };
    std::size_t rowOf(double y) const;

    double low_ = 0, row_height_ = 1;
    std::vector<std::vector<Edge>> rows_;
};

/// Lines without the parts inside the area.
std::vector<DrawnLine> withoutPartsIn(const WallArea& area, std::vector<DrawnLine> lines);

}  // namespace line_drawing
