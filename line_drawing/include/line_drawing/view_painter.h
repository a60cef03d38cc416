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

/// The camera of a window.
struct WindowView {
    ViewFrame frame;  ///< eye and axes, in the coordinates of the objects
    /// From these to OpenGL's clip coordinates; agrees with `frame` up to scale and shift.
    Eigen::Matrix4d to_clip;
    Eigen::Vector2i size;       ///< pixels
    double pixels_per_mm = 10;  ///< pixels for a mm on paper, the unit of pens
};

/// The lines that are painted in one color; they give way only to each other.
struct Ink {
    laplacian_lines::LineKindSet kinds = laplacian_lines::all_kinds();
    /// Only lines behind the surface, undashed; other inks then have none.
    bool is_hidden = false;
};

struct PaintedView {
    Eigen::Vector2i size = {0, 0};
    /// Of each, black lines on white, a byte a pixel, rows from the top, as of a PNG of 8 bits of
    /// gray.
    std::vector<std::vector<std::uint8_t>> inks = {};
    bool is_final = true;  ///< the kernel is that of the view
};

/// Paints objects as make_sheets() draws a view of them, for successive windows. Visibility is
/// prepared once; extractors of the last kernels are cached. One thread at a time.
class ViewPainter {
public:
    /// Objects and what they refer to outlive this.
    explicit ViewPainter(Objects objects);
    ~ViewPainter();

    /// Prepares what does not depend on the view, once. @throws as paint()
    void prepare(const laplacian_lines::Progress& progress = {});

    /// Ignores views, scale, paper and annotations of the options. Without `may_wait`, paints the
    /// lines of the nearest cached kernel, if there is one.
    /// @throws laplacian_lines::Error: Cancelled; InvalidOption if the eye is inside the surface or
    /// sees nothing; InvalidMesh, EmptyMesh. std::bad_alloc
    PaintedView paint(const WindowView& view, SheetOptions options, const std::vector<Ink>& inks,
                      bool may_wait, const laplacian_lines::Progress& progress = {});

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace line_drawing
