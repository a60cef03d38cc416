// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "laplacian_lines/progress.h"
#include "line_drawing/object.h"
#include "line_drawing/sheet_options.h"
#include "line_drawing/view_frame.h"

namespace line_drawing {

/// How a window shows objects.
struct WindowView {
    ViewFrame frame;  ///< eye and axes, in the coordinates of the objects
    /// From there to clip coordinates, OpenGL's: as `frame` has it but for scale and place.
    Eigen::Matrix4d to_clip;
    Eigen::Vector2i size;       ///< pixels
    double pixels_per_mm = 10;  ///< of paper, in which pens are measured
};

/// Black lines on white, a byte a pixel, rows from the top, as of a PNG of 8 bits of gray.
struct GrayPicture {
    Eigen::Vector2i size = {0, 0};
    std::vector<std::uint8_t> grays = {};
};

/// Paints objects as makeSheets() draws a view of them, for window after window: what hides lines
/// is prepared once, lines within faces whenever the kernel changes. One thread at a time.
class ViewPainter {
public:
    /// Objects and what they refer to outlive this.
    explicit ViewPainter(Objects objects);
    ~ViewPainter();

    /// Views, scale, paper and furniture of the options do not matter.
    /// @throws laplacian_lines::Error: Cancelled; InvalidOption if the eye is inside the surface
    /// or sees nothing; InvalidMesh, EmptyMesh. std::bad_alloc
    GrayPicture paint(const WindowView& view, SheetOptions options,
                      const laplacian_lines::Progress& progress = {});

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace line_drawing
