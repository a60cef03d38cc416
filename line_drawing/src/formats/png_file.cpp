// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include <cmath>
#include <new>

#include "formats/sheet_writers.h"
#include "line_drawing/words.h"
#include "pixels/painting.h"

namespace line_drawing {
namespace {

constexpr double kMmPerInch = 25.4;
constexpr double kMostPixels = 32000;  // of a side

std::string number(std::uint32_t value) {
    return {char(value >> 24), char(value >> 16 & 255), char(value >> 8 & 255), char(value & 255)};
}

std::string chunk(const std::string& type, const std::string& data) {
    const std::string both = type + data;
    const auto* bytes = reinterpret_cast<const Bytef*>(both.data());
    return number(std::uint32_t(data.size())) + both +
           number(std::uint32_t(crc32_z(0, bytes, both.size())));
}

/// Rows that are not filtered, as a byte before each says.
std::string rows_of(const Canvas& canvas) {
    std::string rows;
    const auto width = std::size_t(canvas.width());
    const auto* grays = reinterpret_cast<const char*>(canvas.grays().data());
    for (std::size_t begin = 0; begin < canvas.grays().size(); begin += width)
        rows.append(1, '\0').append(grays + begin, width);
    return rows;
}

std::string in_png(const Canvas& canvas, int dots_per_metre) {
    const std::string size =
        number(std::uint32_t(canvas.width())) + number(std::uint32_t(canvas.height()));
    const std::string density = number(std::uint32_t(dots_per_metre)), rows = rows_of(canvas);
    const std::string eight_bits_of_gray{8, 0, 0, 0, 0}, per_metre{1};
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", size + eight_bits_of_gray) +
           chunk("pHYs", density + density + per_metre) + chunk("IDAT", deflated(rows)) +
           chunk("IEND", {});
}

}  // namespace

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(uLong(bytes.size()));
    std::string result(size, '\0');
    if (compress(reinterpret_cast<Bytef*>(result.data()), &size,
                 reinterpret_cast<const Bytef*>(bytes.data()), uLong(bytes.size())) != Z_OK)
        throw std::bad_alloc();
    result.resize(size);
    return result;
}

std::string write_png(const Sheet& sheet, double dpi) {
    const double scale = dpi / kMmPerInch;
    const double width = std::ceil(sheet.size.x() * scale),
                 height = std::ceil(sheet.size.y() * scale);
    if (width > kMostPixels || height > kMostPixels)
        refuse("A picture of " + in_digits(width) + " x " + in_digits(height) +
               " pixels is too large; take fewer dots per inch.");
    return in_png(paint_groups(sheet.groups, {int(width), int(height)}, scale),
                  int(std::lround(scale * 1000)));
}

}  // namespace line_drawing
