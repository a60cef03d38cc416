// SPDX-License-Identifier: GPL-3.0-or-later
#include "pixels/painting.h"

#include "planes/lettering.h"

namespace line_drawing {
namespace {

constexpr double kFlatness = 0.03;  // pixels that a curve may be away from its chords

void add(const SheetPath& path, double scale, Canvas& canvas) {
    const Path placed = path.path.placed(scale, {0, 0});
    const std::vector<Polygon> lines = placed.flattened(kFlatness);
    if (path.pen_width == 0) return canvas.fill(lines, placed.fill_rule, path.tone);
    std::vector<Polygon> strokes;
    for (const Polygon& line : lines)
        append_stroke(line, path.pen_width * scale, path.dash * scale, strokes);
    canvas.fill(strokes, FillRule::NonZero);
}

void add(const SheetText& text, double scale, Canvas& canvas) {
    add(outlines_of(text), scale, canvas);
}

}  // namespace

Canvas paint_groups(const std::vector<SheetGroup>& groups, const Eigen::Vector2i& size,
                    double pixels_per_mm) {
    Canvas canvas(size.x(), size.y());
    for_each_mark(groups, [&](const auto& mark, const auto&, const auto&) {
        add(mark, pixels_per_mm, canvas);
    });
    return canvas;
}

}  // namespace line_drawing
