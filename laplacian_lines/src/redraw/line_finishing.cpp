// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/line_finishing.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "redraw/simd/simd_functions.h"
#include "system/thread_pool.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kLeastParallelPoints = 4000;
constexpr std::size_t kLinesAtOnce = 4;
constexpr std::size_t kColumns = 8;
constexpr std::uint32_t kStripsAhead = 4;
static_assert(sizeof(LinePoint) == 6 * sizeof(float), "finish_line() writes six floats a point");

/// Floats of a column for a line of up to `count` points: whole cache units, one of them before the
/// first point.
constexpr std::size_t kFloatsOfUnit = kCacheUnit / sizeof(float);
std::size_t column_size(std::uint32_t count) {
    return (count + kColumnMargin + 2 * kFloatsOfUnit - 1) / kFloatsOfUnit * kFloatsOfUnit;
}

void reserve_columns(std::vector<float>& memory, std::size_t size) {
    const std::size_t needed = kColumns * size + kFloatsOfUnit;
    if (memory.size() < needed) memory.resize(needed);
}

LineColumns make_columns(std::vector<float>& memory, std::size_t size) {
    void* begin = memory.data();
    std::size_t bytes = memory.size() * sizeof(float);
    std::align(kCacheUnit, kColumns * size * sizeof(float), begin, bytes);
    float* first = static_cast<float*>(begin) + kFloatsOfUnit;
    const auto column = [&](std::size_t i) { return first + i * size; };
    return {column(0), column(1), column(2), column(3), column(4), column(5), column(6), column(7)};
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
    c.concavity[i] = p.concavity;
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

void finish(const ExtractorData& data, const LineRules& rules, const Polyline& p, bool has_exact,
            LineColumns& columns, LinePoint* points) {
    simd_functions().finish_line(
        rules, {p.count, p.closed, has_exact, p.length, p.strength, p.slope}, columns,
        data.centre.data(), data.diagonal, reinterpret_cast<float*>(points));
}

/// Takes a part of a whole line to columns of its own; weights are mean slopes then.
void copy_part(const LinePartFinder& finder, const LinePart& part, const LineColumns& from,
               bool closed, std::uint32_t points, LineColumns& to) {
    for (std::size_t i = 0; i < part.count; ++i) {
        const std::size_t k = closed ? (part.begin + i) % (points - 1) : part.begin + i;
        to.x[i] = from.x[k];
        to.y[i] = from.y[k];
        to.z[i] = from.z[k];
        to.gradient[i] = from.gradient[k];
        to.weight[i] = finder.slope(k);
        to.opacity[i] = from.opacity[k] * finder.opacity(k);
    }
}

void measure(const LineColumns& c, Polyline& p) {
    for (std::uint32_t i = 1; i < p.count; ++i) {
        const Eigen::Vector3f step(c.x[i] - c.x[i - 1], c.y[i] - c.y[i - 1], c.z[i] - c.z[i - 1]);
        const float length = step.norm();
        p.length += length;
        p.strength += (c.gradient[i - 1] + c.gradient[i]) / 2 * length;
        p.slope += c.weight[i] * length;
    }
    p.slope = p.length > 0 ? p.slope / p.length : 0;
}

/// The parts of a whole line that are drawn, to the thread's own memory.
void finish_parts(const ExtractorData& data, const TracedLines& traced,
                  const TracedLines::Line& line, std::size_t size, FinishingThread& thread) {
    LineColumns whole = make_columns(thread.columns, size);
    collect_points(traced, line, whole);
    const Polyline& p = line.polyline;
    if (p.closed) close_line(p.count, whole);
    thread.finder.find(*line.rules, {p.count, p.closed, whole.x, whole.y, whole.z, whole.gradient,
                                     whole.weight, whole.concavity});
    for (const LinePart& part : thread.finder.parts()) {
        LineColumns columns = make_columns(thread.part_columns, size);
        copy_part(thread.finder, part, whole, p.closed, p.count, columns);
        Polyline found;
        found.first = std::uint32_t(thread.points.size());
        found.count = std::uint32_t(part.count);
        found.kind = p.kind;
        found.closed = part.closed;
        measure(columns, found);
        if (found.length < line.rules->least_length || found.strength < line.rules->least_strength)
            continue;
        thread.points.resize(thread.points.size() + part.count);
        Polyline judged = found;
        judged.slope = std::numeric_limits<float>::max();  // means have told what is seen
        finish(data, *line.rules, judged, false, columns, &thread.points[found.first]);
        thread.parts.push_back(found);
    }
}

/// A traced line, to its place.
void finish_line(const ExtractorData& data, const TracedLines& traced,
                 const TracedLines::Line& line, std::size_t size, FinishingThread& thread,
                 LinePoint* points) {
    const Polyline& p = line.polyline;
    LineColumns columns = make_columns(thread.columns, size);
    collect_points(traced, line, columns);
    if (p.closed) close_line(p.count, columns);
    finish(data, *line.rules, p, line.has_exact, columns, points);
}

void append_parts(const FinishingMemory& memory, LineSet& lines) {
    for (const FinishedParts& parts : memory.whole) {
        const FinishingThread& thread = memory.threads[parts.thread];
        for (std::uint32_t i = parts.first; i < parts.first + parts.count; ++i) {
            Polyline p = thread.parts[i];
            const auto begin = thread.points.begin() + p.first;
            p.first = std::uint32_t(lines.points.size());
            lines.points.insert(lines.points.end(), begin, begin + p.count);
            lines.lines.push_back(p);
        }
    }
}

std::uint32_t longest_of(const std::vector<TracedLines::Line>& lines) {
    std::uint32_t longest = 0;
    for (const TracedLines::Line& line : lines)
        longest = std::max(longest, line.polyline.count);
    return longest;
}

}  // namespace

void finish_lines(const ExtractorData& data, const TracedLines& traced, FinishingMemory& memory,
                  LineSet& lines) {
    lines.points.resize(traced.point_count);
    lines.lines.resize(traced.lines.size());
    const std::size_t size =
        column_size(std::max(longest_of(traced.lines), longest_of(traced.whole)));
    const std::size_t whole = traced.whole.size(), count = whole + traced.lines.size();
    const std::size_t blocks = (count + kLinesAtOnce - 1) / kLinesAtOnce;
    const bool is_little = traced.point_count < kLeastParallelPoints && whole == 0;
    const unsigned workers = is_little ? 1 : workers_for(blocks);
    if (memory.threads.size() < workers) memory.threads.resize(workers);
    memory.whole.resize(traced.whole.size());
    for (FinishingThread& thread : memory.threads) {
        reserve_columns(thread.columns, size);
        if (!traced.whole.empty()) reserve_columns(thread.part_columns, size);
        thread.points.clear();
        thread.parts.clear();
    }
    const auto finish_one = [&](std::size_t i, unsigned worker) {
        FinishingThread& thread = memory.threads[worker];
        if (i < whole) {
            const auto first = std::uint32_t(thread.parts.size());
            finish_parts(data, traced, traced.whole[i], size, thread);
            memory.whole[i] = {worker, first, std::uint32_t(thread.parts.size()) - first};
        } else {
            const TracedLines::Line& line = traced.lines[i - whole];
            finish_line(data, traced, line, size, thread, &lines.points[line.polyline.first]);
            lines.lines[i - whole] = line.polyline;
        }
    };
    share(blocks, workers, [&](unsigned worker, Blocks& shared) {
        for (std::size_t block; shared.take(block);)
            for (std::size_t i = block * kLinesAtOnce;
                 i < std::min(count, (block + 1) * kLinesAtOnce); ++i)
                finish_one(i, worker);
    });
    append_parts(memory, lines);
}

}  // namespace laplacian_lines
