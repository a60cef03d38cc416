// SPDX-License-Identifier: GPL-3.0-or-later
#include "pixels/canvas.h"

#include <cstdint>

namespace line_drawing {
namespace {

std::string number(std::uint32_t value) {
    return {char(value >> 24), char(value >> 16 & 255), char(value >> 8 & 255), char(value & 255)};
}

std::uint32_t crc32(const std::string& bytes) {
    std::uint32_t sum = ~0u;
    for (const char c : bytes) {
        sum ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            sum = sum >> 1 ^ (sum & 1 ? 0xedb88320u : 0);
    }
    return ~sum;
}

std::string chunk(const std::string& type, const std::string& data) {
    return number(std::uint32_t(data.size())) + type + data + number(crc32(type + data));
}

}  // namespace

std::string inPng(const Canvas& canvas, int dots_per_metre) {
    const std::string size =
        number(std::uint32_t(canvas.width())) + number(std::uint32_t(canvas.height()));
    const std::string density = number(std::uint32_t(dots_per_metre));
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", size + std::string{8, 0, 0, 0, 0}) +
           chunk("pHYs", density + density + '\1') + chunk("IDAT", deflatedRows(canvas)) +
           chunk("IEND", {});
}

}  // namespace line_drawing
