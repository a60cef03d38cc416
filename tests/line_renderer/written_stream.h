// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "line_stream.h"

/// The points of all parts, one after the other. Nothing may be written between them.
inline std::vector<line_renderer::StreamPoint> writtenStream(
    const laplacian_lines::LineSet& lines, const line_renderer::StreamSettings& settings) {
    const line_renderer::StreamPoint untouched = {{-7, -7, -7}, -7, -7, -7, -7};
    std::vector<line_renderer::StreamPoint> stream(line_renderer::streamLength(lines) + 1,
                                                   untouched),
        result;
    std::vector<line_renderer::StreamPart> parts;
    line_renderer::writeStream(lines, settings, stream.data(), parts);
    std::size_t next = 0;
    const auto skipTo = [&](std::size_t end) {
        for (; next < end; ++next)
            EXPECT_EQ(stream[next].radius, untouched.radius) << "written between parts: " << next;
    };
    for (const line_renderer::StreamPart& part : parts) {
        skipTo(part.first);
        next += part.length;
        EXPECT_LT(next, stream.size()) << "written beyond its length";
        result.insert(result.end(), stream.begin() + std::ptrdiff_t(part.first),
                      stream.begin() + std::ptrdiff_t(next));
    }
    skipTo(stream.size());
    return result;
}
