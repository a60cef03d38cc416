// SPDX-License-Identifier: GPL-3.0-or-later
// How the lines found anew by a redraw are finished, several at once:
//  1. The strips of a line are copied one behind the other.
//  2. A whole line, traced without tests of its segments, fades by its mean slope instead.
//  3. Where a line turns back sharply it fades, and is cut if nothing of it goes on.
//  4. Slopes become weights and opacities, which are smoothed; then open ends run out.
//  5. Positions are smoothed and put into mesh coordinates.
#include "redraw/line_finishing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fixed/line_smoothing.h"
#include "rules/thresholds.h"
#include "system/parallel.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kLeastParallelPoints = 4000;  // fewer are done before a thread wakes
constexpr std::size_t kLinesAtOnce = 4;
constexpr std::uint32_t kStripsAhead = 4;
constexpr int kTaperingPasses = 2;  // slopes of neighbouring triangles differ visibly

/// Asks for a strip that will be copied soon: strips of a line come from all over the memory.
void prefetch_points(const JoinedStrip& strip) {
    const char* begin = reinterpret_cast<const char*>(strip.points);
    for (std::size_t i = 0; i < strip.count * sizeof(StripPoint); i += kCacheUnit)
        __builtin_prefetch(begin + i);
}

/// `slope`: of the segment that ends there, which is the weight until weigh(). A line's first point
/// has one that nothing reads.
LinePoint line_point(const StripPoint& p, float slope) {
    return {Eigen::Vector3f(p.position), slope, p.gradient, p.opacity};
}

/// Copies all strips of a line one behind the other; neighbours share a point.
void collect_points(const TracedLines& traced, const TracedLines::Line& line, LinePoint* to) {
    const std::uint32_t* ends = traced.ends.data() + line.first_end;
    for (std::uint32_t i = 0; i < line.end_count; ++i) {
        if (i + kStripsAhead < line.end_count)
            prefetch_points(line.strips[ends[i + kStripsAhead] / 2]);
        const JoinedStrip& strip = line.strips[ends[i] / 2];
        const StripPoint* const points = strip.points;
        const std::uint32_t last = strip.count - 1;
        const bool backwards = ends[i] % 2 == 1;
        const StripPoint& first = points[backwards ? last : 0];
        if (i == 0)
            *to++ = line_point(first, first.slope);
        else if (std::signbit(first.gradient))  // of a hollow edge, both of whose ends say so
            to[-1].gradient = first.gradient;
        for (std::uint32_t n = 1; n <= last; ++n) {
            const std::uint32_t k = backwards ? last - n : n;
            *to++ = line_point(points[k], points[backwards ? k + 1 : k].slope);
        }
    }
}

/// Without branches, which would be guessed wrong.
float within01(float v) {
    return std::min(std::max(v, 0.f), 1.f);
}

/// From 0 at a threshold to 1 at (1 + fading) times it.
float above(float value, float threshold, const LineRules& rules) {
    return rise(value, threshold, threshold * (1 + rules.fading));
}

/// Weights and opacities by the mean slopes of the segments at points. Of a line that only just
/// passes the tests on whole lines hardly anything is seen, so that it does not jump into the
/// picture when the view turns a little further.
void weigh(const LineRules& rules, const Polyline& p, LinePoint* points) {
    const float whole = std::min({above(p.slope, rules.line_slope, rules),
                                  above(p.length, rules.least_length, rules),
                                  above(p.strength, rules.least_strength, rules)});
    const float range = rules.segment_slope * rules.fading;
    const std::uint32_t last = p.count - 1;
    const float first_slope = points[1].weight, last_slope = points[last].weight;
    points[0].weight = p.closed ? last_slope : first_slope;
    for (std::uint32_t i = 0; i <= last; ++i) {
        const float next = i < last ? points[i + 1].weight : p.closed ? first_slope : last_slope;
        const float over = (points[i].weight + next) / 2 - rules.segment_slope;
        points[i].opacity *= whole * (range > 0 ? within01(over / range) : 1);
        points[i].weight = within01(over / rules.full_slope);
    }
}

/// Smooths weights and opacities, the second and the last of a point's last four numbers.
void smooth_looks(const Polyline& p, LinePoint* points) {
    smooth_binomially<LineEnd::Repeated>(
        p.count, p.closed, kTaperingPasses, [&](std::size_t i) { return four_of(points[i], 2); },
        [&](std::size_t i, const FourOfPoint& v) {
            points[i].weight = v[1];
            points[i].opacity = v[3];
        });
}

/// Lets an open end run out over `length`; `step` leads from it to the inside.
void fade_end(std::uint32_t count, LinePoint* end, int step, float length) {
    float distance = 0;
    for (std::uint32_t i = 0; i < count && distance < length; ++i, end += step) {
        if (i > 0) distance += length_of(end->position - end[-step].position);
        end->opacity *= std::min(distance / length, 1.f);
    }
}

/// Weights and opacities of a line from slopes and from the fading of its crossings.
void taper(const LineRules& rules, const Polyline& p, LinePoint* points) {
    LinePoint& last = points[p.count - 1];
    // Where nothing is seen of the end itself, the line has faded before.
    const bool fades = !p.closed && rules.end_length > 0,
               first_fades = fades && points->opacity > 0, last_fades = fades && last.opacity > 0;
    weigh(rules, p, points);
    smooth_looks(p, points);
    if (first_fades) fade_end(p.count, points, 1, rules.end_length);
    if (last_fades) fade_end(p.count, &last, -1, rules.end_length);
}

/// The points [begin, begin + count) of a line.
Polyline cut(const LinePoint* points, const Polyline& whole, std::size_t begin, std::size_t count) {
    Polyline p = whole;
    p.first = whole.first + std::uint32_t(begin);
    p.count = std::uint32_t(count);
    p.closed = false;
    p.length = p.strength = 0;
    for (std::size_t i = begin + 1; i < begin + count; ++i) {
        const float length = length_of(points[i].position - points[i - 1].position);
        p.length += length;
        p.strength += (points[i - 1].gradient + points[i].gradient) / 2 * length;
    }
    return p;
}

/// Lets a part of a whole line fade at hairpins, and cuts it where it goes.
void cut_at_hairpins(const LineRules& rules, const Polyline& p, FinishingThread& thread,
                     LinePoint* points) {
    if (!thread.hairpins.find(points, p.count, rules.kernel_size)) return;
    thread.hairpins.fade(thread.clear, points);
    const std::vector<float>& passes = thread.hairpins.passes();
    if (std::all_of(passes.begin(), passes.end(), [](float v) { return v > 0; })) return;
    thread.cut_lines.push_back(p.first);
    const auto is_in = [&](std::size_t i) { return passes[i] > 0; };
    for_each_run(p.count, false, is_in, [&](std::size_t begin, std::size_t count) {
        if (count < 2) return;
        const Polyline part = cut(points, p, begin, count);
        if (accepts(rules, part)) thread.cut_parts.push_back(part);
    });
}

/// Weights become the mean slopes of a part of a whole line, and opacities what is seen of it.
void finish_part(const TracedLines& traced, const TracedLines::Line& line, FinishingThread& thread,
                 LinePoint* points) {
    thread.clear.resize(line.polyline.count);
    std::size_t place = 0;
    const auto set_next = [&](float slope, float opacity) {
        points[place].weight = slope;
        points[place].opacity *= opacity;
        thread.clear[place++] = opacity;
    };
    const TracedLines::Knot* from = traced.knots.data() + line.first_knot;
    set_next(from->slope, from->opacity);
    for (std::uint32_t i = 0; i < line.end_count; ++i, ++from) {
        const std::uint32_t end = traced.ends[line.first_end + i];
        const auto segments = float(line.strips[end / 2].count - 1);
        const float slope_step = (from[1].slope - from->slope) / segments,
                    opacity_step = (from[1].opacity - from->opacity) / segments;
        for (float k = 1; k < segments; ++k)
            set_next(from->slope + k * slope_step, from->opacity + k * opacity_step);
        set_next(from[1].slope, from[1].opacity);  // exactly: where it is 0, a line has faded
    }
}

/// A traced line, to its place.
void finish_line(const ExtractorData& data, const TracedLines& traced,
                 const TracedLines::Line& line, FinishingThread& thread, LinePoint* points) {
    const Polyline& p = line.polyline;
    const LineRules& rules = *line.rules;
    collect_points(traced, line, points);
    // The first and the last triangle each say where they meet; in wild meshes they differ.
    if (p.closed) points[p.count - 1].position = points[0].position;
    if (rules.whole) finish_part(traced, line, thread, points);
    if (!is_cut_by_convex(rules)) cut_at_hairpins(rules, p, thread, points);
    if (rules.use_slope) {
        taper(rules, p, points);
    } else {  // contours thin out instead of fading
        for (std::uint32_t i = 0; i < p.count; ++i)
            points[i].weight = std::exchange(points[i].opacity, 1.f);
        smooth_looks(p, points);
    }
    smooth_positions(p, points, rules.smoothing_passes);
    const Eigen::Vector3d centre = data.centre - data.origin;  // as in_line_set(), but hoisted
    const double diagonal = data.diagonal;
    for (std::uint32_t i = 0; i < p.count; ++i)
        points[i].position = (centre + diagonal * points[i].position.cast<double>()).cast<float>();
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
void replace_cut_lines(FinishingMemory& threads, LineSet& set) {
    std::vector<Polyline>& lines = set.lines;
    std::vector<std::uint32_t>& cut_lines = threads[0].cut_lines;  // gets those of the others
    std::vector<Polyline>& parts = threads[0].cut_parts;
    for (auto other = threads.begin() + 1; other != threads.end(); ++other) {
        cut_lines.insert(cut_lines.end(), other->cut_lines.begin(), other->cut_lines.end());
        parts.insert(parts.end(), other->cut_parts.begin(), other->cut_parts.end());
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
    const std::size_t count = traced.lines.size();
    const std::size_t blocks = (count + kLinesAtOnce - 1) / kLinesAtOnce;
    const unsigned workers = traced.point_count < kLeastParallelPoints ? 1 : workers_for(blocks);
    if (memory.size() < workers) memory.resize(workers);
    for (FinishingThread& thread : memory) {
        thread.cut_lines.clear();
        thread.cut_parts.clear();
    }
    share(blocks, workers, [&](unsigned worker, Blocks& shared) {
        for (std::size_t block; shared.take(block);)
            for (std::size_t i = block * kLinesAtOnce;
                 i < std::min(count, (block + 1) * kLinesAtOnce); ++i) {
                const TracedLines::Line& line = traced.lines[i];
                finish_line(data, traced, line, memory[worker], &lines.points[line.polyline.first]);
                lines.lines[i] = line.polyline;
            }
    });
    replace_cut_lines(memory, lines);
}

}  // namespace laplacian_lines
