// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "line_drawing/path.h"

namespace line_drawing {

/// In pixels, x right and y down, closed.
using Polygon = std::vector<Path::Point>;

/// A gray picture, white at first. A pixel is as dark as the share of it that is covered: to a
/// 256th along x, in 16 scan lines along y. Uses basic operations only, so that all machines give
/// the same bits.
class Canvas {
public:
    /// @throws std::bad_alloc
    Canvas(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    /// A byte a pixel, row by row.
    const std::vector<std::uint8_t>& grays() const& { return grays_; }
    std::vector<std::uint8_t>&& grays() && { return std::move(grays_); }

    /// Fills the polygons together, clipped to the picture, without those whose coordinates are not
    /// finite. `tone`: 0 black, 1 white.
    void fill(const std::vector<Polygon>& polygons, FillRule rule, double tone = 0);

private:
    const int width_, height_;
    std::vector<std::uint8_t> grays_;
};

/// A stroke as polygons for FillRule::NonZero, in pixels. The pen is round, dashes have flat ends
/// and gaps of half their length. A line of one point gives nothing; a line without length a dot,
/// or nothing if dashed.
void append_stroke(const Polygon& line, double width, double dash, std::vector<Polygon>& polygons);

}  // namespace line_drawing
