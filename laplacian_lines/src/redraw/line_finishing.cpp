// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/line_finishing.h"

#include <algorithm>
#include <cmath>

#include "rules/line_acceptance.h"
#include "rules/opacity.h"
#include "system/parallel.h"
#include "system/simd_sets.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr float kReach = 0.375f;            // to both sides, in √h
constexpr float kSharpestCosine = -0.342f;  // of 110°

/// Cosine between the ways from a to b and from b to c; 1 where there is none.
float cosine_of_turn(const LineColumns& p, std::size_t a, std::size_t b, std::size_t c) {
    const float ux = p.x[b] - p.x[a], uy = p.y[b] - p.y[a], uz = p.z[b] - p.z[a];
    const float vx = p.x[c] - p.x[b], vy = p.y[c] - p.y[b], vz = p.z[c] - p.z[b];
    const float product = ux * vx + uy * vy + uz * vz;
    if (product >= 0) return 1;
    const float squares = (ux * ux + uy * uy + uz * uz) * (vx * vx + vy * vy + vz * vz);
    return product / std::sqrt(squares);
}

}  // namespace

void Hairpins::measure(const LineColumns& line) {
    for (std::size_t i = 1; i < lengths_.size(); ++i) {
        const float x = line.x[i] - line.x[i - 1], y = line.y[i] - line.y[i - 1],
                    z = line.z[i] - line.z[i - 1];
        lengths_[i] = std::sqrt(x * x + y * y + z * z);
    }
    for (std::size_t i = 1; i < lengths_.size(); ++i)
        lengths_[i] += lengths_[i - 1];
}

bool Hairpins::find(const LineColumns& line, std::uint32_t count, float kernel_size) {
    lengths_.assign(count, 0.f);
    passes_.assign(count, 1.f);
    measure(line);
    const float reach = kReach * kernel_size;
    bool any = false;
    std::size_t low = 0, high = 0;
    for (std::size_t i = 0; i < count && high < count; ++i) {
        while (low < i && lengths_[low + 1] <= lengths_[i] - reach)
            ++low;
        while (high < count && lengths_[high] < lengths_[i] + reach)
            ++high;
        if (lengths_[low] > lengths_[i] - reach || high == count) continue;
        passes_[i] = rise(cosine_of_turn(line, low, i, high), kSharpestCosine, 0);
        any |= passes_[i] < 1;
    }
    return any;
}

void Hairpins::split(const float* starts) {
    limbs_.clear();
    ranges_.clear();
    const auto count = std::uint32_t(passes_.size());
    limbs_.push_back({0, 0, 0, 0});
    std::uint32_t begin = 0;  // of what no hairpin cuts
    for (std::uint32_t i = 0; i < count; ++i) {
        limbs_.back().carried = std::max(limbs_.back().carried, starts[i] * passes_[i]);
        const bool turns = i > 0 && i + 1 < count && passes_[i] < 1 &&
                           passes_[i] <= passes_[i - 1] && passes_[i] < passes_[i + 1];
        if (turns) {
            limbs_.back().end = i;
            limbs_.push_back({i, i, passes_[i], 0});
        }
        if (passes_[i] > 0) continue;
        if (i > begin + 1) ranges_.push_back({begin, i});
        begin = i + 1;
    }
    limbs_.back().end = count;
    if (count > begin + 1) ranges_.push_back({begin, count});
}

/// From limb to limb, both ways; returns the most.
float Hairpins::carry() {
    for (std::size_t i = 1; i < limbs_.size(); ++i)
        limbs_[i].carried =
            std::max(limbs_[i].carried, std::min(limbs_[i].passes, limbs_[i - 1].carried));
    float most = 0;
    for (std::size_t i = limbs_.size(); i-- > 0; most = std::max(most, limbs_[i].carried))
        if (i + 1 < limbs_.size())
            limbs_[i].carried =
                std::max(limbs_[i].carried, std::min(limbs_[i + 1].passes, limbs_[i + 1].carried));
    return most;
}

void Hairpins::fade(const float* starts, float* opacities) {
    split(starts);
    const float most = carry();
    for (const Limb& limb : limbs_) {
        const float carried = most > 0 ? std::min(1.f, 2 * limb.carried / most) : 1.f;
        for (std::uint32_t i = limb.begin; i < limb.end; ++i)
            opacities[i] *= std::min(passes_[i], carried);
    }
}

namespace {

constexpr std::uint32_t kLeastParallelPoints = 4000;
constexpr std::size_t kLinesAtOnce = 4;
constexpr std::size_t kColumns = 7;
constexpr std::uint32_t kStripsAhead = 4;
static_assert(sizeof(LinePoint) == 6 * sizeof(float), "finish_line() writes six floats a point");

/// Of a column for a line of up to `count` points: one of them before the first point.
std::size_t column_units(std::uint32_t count) {
    return (count + kColumnMargin - 1) / FinishingThread::kUnitFloats + 2;
}

LineColumns make_columns(std::vector<FinishingThread::Unit>& columns, std::size_t units) {
    const auto column = [&](std::size_t i) { return columns[i * units + 1].floats; };
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
        const StripPoint* const points = strip.points;
        const std::uint32_t last = strip.count - 1;
        const bool backwards = ends[i] % 2 == 1;
        if (i == 0) set_point(columns, place++, points[backwards ? last : 0], 0);
        for (std::uint32_t k = 1; k <= last; ++k)
            if (backwards)
                set_point(columns, place++, points[last - k], points[last - k + 1].slope);
            else
                set_point(columns, place++, points[k], points[k].slope);
    }
}

/// Where a line crosses an edge, both triangles say; in meshes that are wild they differ.
void close_line(std::uint32_t count, const LineColumns& c) {
    for (float* column : {c.x, c.y, c.z})
        column[count - 1] = column[0];
}

void finish(const ExtractorData& data, const LineRules& rules, const Polyline& p, bool has_exact,
            LineColumns& columns, LinePoint* points) {
    const Eigen::Vector3d centre = data.centre - data.origin;
    fastest<RedrawLoops>().finish_line(
        rules, {p.count, p.closed, has_exact, p.length, p.strength, p.slope}, columns,
        centre.data(), data.diagonal, reinterpret_cast<float*>(points));
}

/// Goes from knot to knot along a part of a whole line; visit(point, value) is called for each
/// point.
template <class Value, class Visit>
void interpolate(const TracedLines& traced, const TracedLines::Line& line, Value value,
                 Visit visit) {
    const std::uint32_t* ends = traced.ends.data() + line.first_end;
    const TracedLines::Knot* knots = traced.knots.data() + line.first_knot;
    visit(0, knots[0].*value);
    std::size_t place = 1;
    for (std::uint32_t i = 0; i < line.end_count; ++i) {
        const std::uint32_t segments = line.strips[ends[i] / 2].count - 1;
        const float from = knots[i].*value, step = (knots[i + 1].*value - from) / float(segments);
        for (std::uint32_t k = 1; k < segments; ++k)
            visit(place++, from + float(k) * step);
        visit(place++, knots[i + 1].*value);  // exactly: where it is 0, a line has faded
    }
}

/// Polylines of the points between hairpins.
void cut(const LineRules& rules, const LineColumns& c, const Polyline& whole,
         const std::vector<Hairpins::Range>& ranges, std::vector<Polyline>& parts) {
    for (const Hairpins::Range& range : ranges) {
        Polyline p = whole;
        p.first = whole.first + range.begin;
        p.count = range.end - range.begin;
        p.closed = false;
        p.length = p.strength = 0;
        for (std::uint32_t i = range.begin + 1; i < range.end; ++i) {
            const float length =
                length_of({c.x[i] - c.x[i - 1], c.y[i] - c.y[i - 1], c.z[i] - c.z[i - 1]});
            p.length += length;
            p.strength += (c.gradient[i - 1] + c.gradient[i]) / 2 * length;
        }
        if (accepts(rules, p)) parts.push_back(p);
    }
}

/// Weights become the mean slopes of a part of a whole line, and opacities what is seen of it.
void finish_part(const TracedLines& traced, const TracedLines::Line& line, const LineColumns& c,
                 FinishingThread& thread) {
    using Knot = TracedLines::Knot;
    interpolate(traced, line, &Knot::slope, [&](std::size_t i, float v) { c.weight[i] = v; });
    interpolate(traced, line, &Knot::opacity, [&](std::size_t i, float v) { c.opacity[i] *= v; });
    const Polyline& p = line.polyline;
    if (line.rules->cut_by_convex()) return;
    if (!thread.hairpins.find(c, p.count, line.rules->kernel_size)) return;
    interpolate(traced, line, &Knot::opacity, [&](std::size_t i, float v) { c.spare[i] = v; });
    thread.hairpins.fade(c.spare, c.opacity);
    const std::vector<Hairpins::Range>& ranges = thread.hairpins.ranges();
    if (ranges.size() == 1 && ranges[0].end - ranges[0].begin == p.count) return;
    cut(*line.rules, c, p, ranges, thread.cut_parts);
    thread.cut_lines.push_back(p.first);
}

/// A traced line, to its place.
void finish_line(const ExtractorData& data, const TracedLines& traced,
                 const TracedLines::Line& line, std::size_t units, FinishingThread& thread,
                 LinePoint* points) {
    const Polyline& p = line.polyline;
    LineColumns columns = make_columns(thread.columns, units);
    collect_points(traced, line, columns);
    if (p.closed) close_line(p.count, columns);
    if (line.rules->whole) finish_part(traced, line, columns, thread);
    finish(data, *line.rules, p, line.has_exact, columns, points);
}

/// Leaves out points that are of no line. Lines are in the order of their points.
void pack(LineSet& lines) {
    std::uint32_t next = 0;
    for (Polyline& line : lines.lines) {
        const auto first = lines.points.begin() + line.first;
        if (line.first != next) std::move(first, first + line.count, lines.points.begin() + next);
        line.first = next;
        next += line.count;
    }
    lines.points.resize(next);
}

/// Puts what hairpins have cut in the places of the lines that were cut.
void replace_cut_lines(const std::vector<FinishingThread>& threads, LineSet& set) {
    std::vector<Polyline>& lines = set.lines;
    std::vector<std::uint32_t> cut_lines;
    std::vector<Polyline> parts;
    for (const FinishingThread& thread : threads) {
        cut_lines.insert(cut_lines.end(), thread.cut_lines.begin(), thread.cut_lines.end());
        parts.insert(parts.end(), thread.cut_parts.begin(), thread.cut_parts.end());
    }
    if (cut_lines.empty()) return;
    std::sort(cut_lines.begin(), cut_lines.end());
    const auto is_cut = [&](const Polyline& p) {
        return std::binary_search(cut_lines.begin(), cut_lines.end(), p.first);
    };
    lines.erase(std::remove_if(lines.begin(), lines.end(), is_cut), lines.end());
    lines.insert(lines.end(), parts.begin(), parts.end());
    std::sort(lines.begin(), lines.end(),
              [](const Polyline& a, const Polyline& b) { return a.first < b.first; });
    pack(set);
}

}  // namespace

void finish_lines(const ExtractorData& data, const TracedLines& traced, FinishingMemory& memory,
                  LineSet& lines) {
    lines.points.resize(traced.point_count);
    lines.lines.resize(traced.lines.size());
    std::uint32_t longest = 0;
    for (const TracedLines::Line& line : traced.lines)
        longest = std::max(longest, line.polyline.count);
    const std::size_t units = column_units(longest);
    const std::size_t count = traced.lines.size();
    const std::size_t blocks = (count + kLinesAtOnce - 1) / kLinesAtOnce;
    const unsigned workers = traced.point_count < kLeastParallelPoints ? 1 : workers_for(blocks);
    if (memory.size() < workers) memory.resize(workers);
    for (FinishingThread& thread : memory) {
        if (thread.columns.size() < kColumns * units) thread.columns.resize(kColumns * units);
        thread.cut_lines.clear();
        thread.cut_parts.clear();
    }
    share(blocks, workers, [&](unsigned worker, Blocks& shared) {
        for (std::size_t block; shared.take(block);)
            for (std::size_t i = block * kLinesAtOnce;
                 i < std::min(count, (block + 1) * kLinesAtOnce); ++i) {
                const TracedLines::Line& line = traced.lines[i];
                finish_line(data, traced, line, units, memory[worker],
                            &lines.points[line.polyline.first]);
                lines.lines[i] = line.polyline;
            }
    });
    replace_cut_lines(memory, lines);
}

}  // namespace laplacian_lines
