// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include <cmath>
#include <new>

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

std::string number(std::uint32_t value) {
    return {char(value >> 24), char(value >> 16 & 255), char(value >> 8 & 255), char(value & 255)};
}

std::string chunk(const std::string& type, const std::string& data) {
    const std::string both = type + data;
    const auto* bytes = reinterpret_cast<const Bytef*>(both.data());
    return number(std::uint32_t(data.size())) + both +
           number(std::uint32_t(crc32_z(0, bytes, both.size())));
}

/// Rows that are not filtered, which their first byte says.
std::string inPng(const Canvas& canvas, int dots_per_metre) {
    const std::string size =
        number(std::uint32_t(canvas.width())) + number(std::uint32_t(canvas.height()));
    const std::string density = number(std::uint32_t(dots_per_metre));
    const auto* rows = reinterpret_cast<const char*>(canvas.bytes().data());
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", size + std::string{8, 0, 0, 0, 0}) +
           chunk("pHYs", density + density + '\1') +
           chunk("IDAT", deflated({rows, canvas.bytes().size()})) + chunk("IEND", {});
}

}  // namespace

std::string deflated(std::string_view bytes) {
    uLongf size = compressBound(uLong(bytes.size()));
    std::string result(size, '\0');
    if (compress(reinterpret_cast<Bytef*>(result.data()), &size,
                 reinterpret_cast<const Bytef*>(bytes.data()), uLong(bytes.size())) != Z_OK)
        throw std::bad_alloc();
    result.resize(size);
    return result;
}

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
