// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "formats/sheet_writers.h"
#include "line_drawing/words.h"
#include "pixels/canvas.h"
#include "planes/lettering.h"

namespace line_drawing {
namespace {

constexpr double mm_per_inch = 25.4;
constexpr double most_pixels = 32000;  // of a side
constexpr double flatness = 0.03;      // pixels that a curve may be away from its chords

class Painting {
public:
    Painting(const Sheet& sheet, int width, int height, double scale)
        : scale_(scale), canvas_(width, height) {
        forEachMark(sheet, [&](const auto& mark, const auto&, const auto&) { add(mark); });
    }

    const Canvas& canvas() const { return canvas_; }

private:
    void add(const SheetPath& path) {
        const Path placed = path.path.placed(scale_, {0, 0});
        const std::vector<Polygon> lines = placed.flattened(flatness);
        if (path.pen_width == 0) return canvas_.fill(lines, placed.fill_rule, path.tone);
        std::vector<Polygon> strokes;
        for (const Polygon& line : lines)
            appendStroke(line, path.pen_width * scale_, path.dash * scale_, strokes);
        canvas_.fill(strokes, FillRule::NonZero);
    }

    void add(const SheetText& text) { add(outlinesOf(text)); }

    const double scale_;
    Canvas canvas_;
};

}  // namespace

std::string writePng(const Sheet& sheet, double dpi) {
    const double scale = dpi / mm_per_inch;
    const double width = std::ceil(sheet.size.x() * scale),
                 height = std::ceil(sheet.size.y() * scale);
    if (width > most_pixels || height > most_pixels)
        refuse("A picture of " + inDigits(width) + " x " + inDigits(height) +
               " pixels is too large; take fewer dots per inch.");
    const Painting painting(sheet, int(width), int(height), scale);
    return inPng(painting.canvas(), int(std::lround(scale * 1000)));
}

}  // namespace line_drawing
