// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/line_finishing.h"

#include <omp.h>

#include <algorithm>
#include <memory>

#include "redraw/simd/simd_functions.h"
#include "system/affordable_threads.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kLeastParallelPoints = 4000;
constexpr std::size_t kColumns = 7;
constexpr std::uint32_t kStripsAhead = 4;
static_assert(sizeof(LinePoint) == 6 * sizeof(float), "finish_line() writes six floats a point");

/// Floats of a column for a line of up to `count` points: whole cache units, one of them before the
/// first point.
constexpr std::size_t kFloatsOfUnit = kCacheUnit / sizeof(float);
std::size_t column_size(std::uint32_t count) {
    return (count + kColumnMargin + 2 * kFloatsOfUnit - 1) / kFloatsOfUnit * kFloatsOfUnit;
}

LineColumns make_columns(std::vector<float>& memory, std::size_t size) {
    void* begin = memory.data();
    std::size_t bytes = memory.size() * sizeof(float);
    std::align(kCacheUnit, kColumns * size * sizeof(float), begin, bytes);
    float* first = static_cast<float*>(begin) + kFloatsOfUnit;
    const auto column = [&](std::size_t i) { return first + i * size; };
    return {column(0), column(1), column(2), column(3), column(4), column(5), column(6)};
}

/// Asks for a strip that will be copied soon: strips of a line come from all over the memory.
void prefetch_points(const JoinedStrip& strip) {
    const char* begin = reinterpret_cast<const char*>(strip.points);
    for (std::size_t i = 0; i < strip.count * sizeof(StripPoint); i += kCacheUnit)
        __builtin_prefetch(begin + i);
}

void set_point(const LineColumns& c, std::size_t i, const StripPoint& p, float slope) {
    c.x[i] = p.position[0];
    c.y[i] = p.position[1];
    c.z[i] = p.position[2];
    c.gradient[i] = p.gradient;
    c.opacity[i] = p.opacity;
    c.weight[i] = slope;
}

/// Copies all strips of a line one behind the other; neighbours share a point.
void collect_points(const TracedLines& traced, const TracedLines::Line& line,
                    const LineColumns& columns) {
    std::size_t place = 0;
    const std::uint32_t* ends = traced.ends.data() + line.first_end;
    for (std::uint32_t i = 0; i < line.end_count; ++i) {
        if (i + kStripsAhead < line.end_count)
            prefetch_points(line.strips[ends[i + kStripsAhead] / 2]);
        const JoinedStrip& strip = line.strips[ends[i] / 2];
        const std::uint32_t last = strip.count - 1;
        if (ends[i] % 2 == 0) {
            if (i == 0) set_point(columns, place++, strip.points[0], 0);
            simd_functions().append_points(strip.points + 1, last, columns, place);
            place += last;
        } else {  // backwards
            if (i == 0) set_point(columns, place++, strip.points[last], 0);
            for (std::uint32_t k = last; k > 0; --k)
                set_point(columns, place++, strip.points[k - 1], strip.points[k].slope);
        }
    }
}

/// Where a line crosses an edge, both triangles say; in meshes that are wild they differ.
void close_line(std::uint32_t count, const LineColumns& c) {
    for (float* column : {c.x, c.y, c.z})
        column[count - 1] = column[0];
}

}  // namespace

void finish_lines(const ExtractorData& data, const TracedLines& traced, FinishingMemory& memory,
                  LineSet& lines) {
    lines.points.resize(traced.point_count);
    lines.lines.resize(traced.lines.size());
    std::uint32_t longest = 0;
    for (const TracedLines::Line& line : traced.lines)
        longest = std::max(longest, line.polyline.count);
    const std::size_t size = column_size(longest);
    const int threads =
        traced.point_count < kLeastParallelPoints ? 1 : affordable_threads(omp_get_max_threads());
    if (memory.size() < std::size_t(threads)) memory.resize(std::size_t(threads));
    for (std::vector<float>& columns : memory)
        if (columns.size() < kColumns * size + kFloatsOfUnit)
            columns.resize(kColumns * size + kFloatsOfUnit);
    const auto count = std::int64_t(traced.lines.size());
#pragma omp parallel for schedule(dynamic, 4) num_threads(threads) if (threads > 1)
    for (std::int64_t i = 0; i < count; ++i) {
        const TracedLines::Line& line = traced.lines[std::size_t(i)];
        const Polyline& p = line.polyline;
        LineColumns columns = make_columns(memory[std::size_t(omp_get_thread_num())], size);
        collect_points(traced, line, columns);
        if (p.closed) close_line(p.count, columns);
        simd_functions().finish_line(
            *line.rules, {p.count, p.closed, line.has_exact, p.length, p.strength, p.slope},
            columns, data.centre.data(), data.diagonal,
            reinterpret_cast<float*>(lines.points.data() + p.first));
        lines.lines[std::size_t(i)] = p;
    }
}

}  // namespace laplacian_lines
