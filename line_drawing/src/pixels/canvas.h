// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "line_drawing/path.h"

namespace line_drawing {

/// Corners, in pixels, x to the right and y down; from the last one straight to the first.
using Polygon = std::vector<Path::Point>;

/// A gray picture, white at first. A pixel is as dark as the share of it that is covered: exactly
/// across, and of 16 lines down. Of basic operations alone, so that all machines have the same
/// bits.
class Canvas {
public:
    /// @throws std::bad_alloc
    Canvas(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    /// 0 black, 255 white
    const std::uint8_t* row(int y) const { return grays_.data() + std::size_t(y) * width_; }

    /// What is inside of the polygons together, whatever is within the picture of it. Polygons with
    /// coordinates that are not finite are left out. `tone`: 0 black, 1 white.
    void fill(const std::vector<Polygon>& polygons, FillRule rule, double tone = 0);

private:
    const int width_, height_;
    std::vector<std::uint8_t> grays_;
};

/// What a pen covers along a line, as polygons to be filled by FillRule::NonZero; all in pixels.
/// Its tip is round, and of dashes, which have gaps of half of their length, cut off. A line of one
/// point has nothing; one without length has a dot, or of dashes nothing.
void appendStroke(const Polygon& line, double width, double dash, std::vector<Polygon>& polygons);

}  // namespace line_drawing
