// SPDX-License-Identifier: GPL-3.0-or-later
// A page as PNG: 256 grays, one chunk of rows, the density for true scale, the provenance as a
// comment.
#include <zlib.h>

#include <cmath>
#include <new>

#include "formats/sheet_writers.h"
#include "line_drawing/words.h"
#include "pixels/painting.h"

namespace line_drawing {
namespace {

constexpr double kMmPerInch = 25.4;
constexpr double kMostPixels = 32000;  // of a side: rows fit into one chunk, of 2 GiB at most
constexpr double kRounding = 1e-6;     // pixels

std::string in_big_endian(std::size_t number) {
    return {char(number >> 24), char(number >> 16), char(number >> 8), char(number)};
}

std::string chunk(const std::string& type, const std::string& data) {
    const std::string both = type + data;
    const auto* bytes = reinterpret_cast<const Bytef*>(both.data());
    return in_big_endian(data.size()) + both + in_big_endian(crc32_z(0, bytes, both.size()));
}

/// Rows that are not filtered, as a byte before each says.
std::string rows_of(const Canvas& canvas) {
    std::string rows;
    rows.reserve(canvas.grays().size() + std::size_t(canvas.height()));
    const auto width = std::size_t(canvas.width());
    const auto* grays = reinterpret_cast<const char*>(canvas.grays().data());
    for (std::size_t begin = 0; begin < canvas.grays().size(); begin += width)
        rows.append(1, '\0').append(grays + begin, width);
    return rows;
}

std::string in_png(const Canvas& canvas, long dots_per_metre, const std::string& provenance) {
    const std::string size =
        in_big_endian(std::size_t(canvas.width())) + in_big_endian(std::size_t(canvas.height()));
    const std::string density = in_big_endian(std::size_t(dots_per_metre));
    const std::string eight_bits_of_gray{8, 0, 0, 0, 0}, per_metre{1};
    const std::string comment =
        provenance.empty() ? "" : chunk("tEXt", std::string("Comment") + '\0' + provenance);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", size + eight_bits_of_gray) +
           chunk("pHYs", density + density + per_metre) + comment +
           chunk("IDAT", deflated(rows_of(canvas))) + chunk("IEND", {});
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
    const double width = std::ceil(sheet.size.x() * scale - kRounding),
                 height = std::ceil(sheet.size.y() * scale - kRounding);
    if (width > kMostPixels || height > kMostPixels)
        refuse("A picture of " + in_decimals(width, 0) + " x " + in_decimals(height, 0) +
               " pixels is too large; take fewer dots per inch.");
    return in_png(paint_groups(sheet.groups, {int(width), int(height)}, scale),
                  std::lround(scale * 1000), sheet.provenance);
}

}  // namespace line_drawing
