// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_finishing.h"

#include <omp.h>

#include <algorithm>

#include "cluster_kernels.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kLeastParallelPoints = 4000;
constexpr std::size_t kColumns = 7;
static_assert(sizeof(LinePoint) == 6 * sizeof(float), "finish_line() writes six floats a point");

/// Room for the columns of a line of up to `count` points. Columns begin on cache lines apart from
/// the place before them.
std::size_t column_size(std::uint32_t count) {
    return (count + 1 + kColumnMargin + 15) / 16 * 16;
}

LineColumns make_columns(std::vector<float>& memory, std::size_t size) {
    float* first = memory.data() + 1;
    const auto column = [&](std::size_t i) { return first + i * size; };
    return {column(0), column(1), column(2), column(3), column(4), column(5), column(6)};
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
    for (std::uint32_t i = 0; i < line.end_count; ++i) {
        const std::uint32_t end = traced.ends[line.first_end + i];
        const JoinedStrip& strip = line.strips[end / 2];
        const StripPoint* points = strip.points;
        const std::uint32_t last = strip.count - 1;
        if (end % 2 == 0) {
            if (i == 0) set_point(columns, place++, points[0], 0);
            for (std::uint32_t k = 1; k <= last; ++k)
                set_point(columns, place++, points[k], points[k].slope);
        } else {  // backwards
            if (i == 0) set_point(columns, place++, points[last], 0);
            for (std::uint32_t k = last; k > 0; --k)
                set_point(columns, place++, points[k - 1], points[k].slope);
        }
    }
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
    const int threads = traced.point_count < kLeastParallelPoints ? 1 : omp_get_max_threads();
    if (memory.size() < std::size_t(threads)) memory.resize(std::size_t(threads));
    for (std::vector<float>& columns : memory)
        if (columns.size() < kColumns * size) columns.resize(kColumns * size);
    const auto count = std::int64_t(traced.lines.size());
#pragma omp parallel for schedule(dynamic, 4) num_threads(threads) if (threads > 1)
    for (std::int64_t i = 0; i < count; ++i) {
        const TracedLines::Line& line = traced.lines[std::size_t(i)];
        const Polyline& p = line.polyline;
        LineColumns columns = make_columns(memory[std::size_t(omp_get_thread_num())], size);
        collect_points(traced, line, columns);
        cluster_kernels().finish_line(*line.rules,
                                      {p.count, p.closed, p.length, p.strength, p.slope}, columns,
                                      data.centre.data(), data.diagonal,
                                      reinterpret_cast<float*>(lines.points.data() + p.first));
        lines.lines[std::size_t(i)] = p;
    }
}

}  // namespace laplacian_lines
