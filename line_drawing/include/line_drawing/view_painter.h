// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "laplacian_lines/line_mixture.h"
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

/// Which lines a picture has.
struct Ink {
    laplacian_lines::LineKindSet kinds = laplacian_lines::all_kinds();
    /// Those behind the surface, undashed; they are in no other ink then.
    bool is_hidden = false;
};

struct PaintedView {
    Eigen::Vector2i size = {0, 0};
    /// Of each, black lines on white, a byte a pixel, rows from the top, as of a PNG of 8 bits of
    /// gray.
    std::vector<std::vector<std::uint8_t>> inks = {};
    bool is_final = true;  ///< the kernel is that of the view
};

/// Paints objects as make_sheets() draws a view of them, for window after window: what hides lines
/// is prepared once; lines within faces for each kernel, and kept. One thread at a time.
class ViewPainter {
public:
    /// Objects and what they refer to outlive this.
    explicit ViewPainter(Objects objects);
    ~ViewPainter();

    /// What does not depend on the view, unless that is done. @throws as paint()
    void prepare(const laplacian_lines::Progress& progress = {});

    /// Views, scale, paper and furniture of the options do not matter. `may_wait`: else lines of
    /// the nearest kernel are painted that is at hand, if any is.
    /// @throws laplacian_lines::Error: Cancelled; InvalidOption if the eye is inside the surface
    /// or sees nothing; InvalidMesh, EmptyMesh. std::bad_alloc
    PaintedView paint(const WindowView& view, SheetOptions options, const std::vector<Ink>& inks,
                      bool may_wait, const laplacian_lines::Progress& progress = {});

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace line_drawing
