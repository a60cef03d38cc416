// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/line_parts.h"

#include <algorithm>
#include <cmath>

namespace laplacian_lines {
namespace {

constexpr int kBisections = 8;

struct Sample {
    LinePlace place;
    double length;  ///< from here to the next sample
    bool holds;
};

std::uint32_t segment_count(const Polyline& line) {
    return line.count > 0 ? line.count - 1 : 0;
}

double segment_length(const LineSet& lines, const Polyline& line, std::uint32_t segment) {
    const LinePoint* points = lines.points.data() + line.first;
    return double((points[segment + 1].position - points[segment].position).norm());
}

/// Places at most rules.spacing apart, all points of the line among them. The end of a closed line
/// is its beginning and not there twice.
std::vector<Sample> take_samples(const LineSet& lines, const Polyline& line, double spacing,
                                 const std::function<bool(const LinePlace&)>& holds) {
    std::vector<Sample> samples;
    const auto add = [&](const LinePlace& place, double length) {
        samples.push_back({place, length, holds(place)});
    };
    for (std::uint32_t segment = 0; segment < segment_count(line); ++segment) {
        const double length = segment_length(lines, line, segment);
        const int pieces = std::max(1, int(std::ceil(length / spacing)));
        for (int i = 0; i < pieces; ++i)
            add({segment, double(i) / pieces}, length / pieces);
    }
    if (!line.closed && segment_count(line) > 0) add({segment_count(line) - 1, 1}, 0);
    return samples;
}

/// So that no run of a closed line is cut at the first point.
void begin_with_a_change(std::vector<Sample>& samples) {
    for (std::size_t i = 1; i < samples.size(); ++i)
        if (samples[i].holds != samples[i - 1].holds) {
            std::rotate(samples.begin(), samples.begin() + std::ptrdiff_t(i), samples.end());
            return;
        }
}

struct Run {
    std::size_t begin, end;  ///< samples [begin, end)
    bool holds;
};

std::vector<Run> runs_of(const std::vector<Sample>& samples) {
    std::vector<Run> runs;
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (runs.empty() || runs.back().holds != samples[i].holds)
            runs.push_back({i, i + 1, samples[i].holds});
        else
            runs.back().end = i + 1;
    return runs;
}

/// Turns short runs of one kind into their neighbours'.
void flip_short_runs(std::vector<Sample>& samples, bool kind, double shortest) {
    const std::vector<Run> runs = runs_of(samples);
    if (runs.size() < 2) return;
    for (const Run& run : runs) {
        double length = 0;
        for (std::size_t i = run.begin; i < run.end; ++i)
            length += samples[i].length;
        if (run.holds != kind || length >= shortest) continue;
        for (std::size_t i = run.begin; i < run.end; ++i)
            samples[i].holds = !kind;
    }
}

/// The place between two neighbouring samples where it begins or ceases to hold. The later one may
/// be the first point of the next segment, which is the end of this one.
LinePlace change_between(const Sample& earlier, LinePlace later,
                         const std::function<bool(const LinePlace&)>& holds) {
    if (later.segment != earlier.place.segment) later = {earlier.place.segment, 1};
    double low = earlier.place.t, high = later.t;
    for (int i = 0; i < kBisections; ++i) {
        const double middle = (low + high) / 2;
        (holds({later.segment, middle}) == earlier.holds ? low : high) = middle;
    }
    return {later.segment, (low + high) / 2};
}

}  // namespace

LinePoint point_at(const LineSet& lines, const Polyline& line, const LinePlace& place) {
    const LinePoint& a = lines.points[line.first + place.segment];
    const LinePoint& b = lines.points[line.first + place.segment + 1];
    const float t = float(place.t);
    return {a.position + t * (b.position - a.position), a.weight + t * (b.weight - a.weight),
            a.gradient + t * (b.gradient - a.gradient), a.opacity + t * (b.opacity - a.opacity)};
}

std::vector<LinePart> parts_where(const LineSet& lines, const Polyline& line,
                                  const PartRules& rules,
                                  const std::function<bool(const LinePlace&)>& holds) {
    std::vector<Sample> samples = take_samples(lines, line, rules.spacing, holds);
    if (line.closed) begin_with_a_change(samples);
    flip_short_runs(samples, false, rules.shortest);
    if (line.closed) begin_with_a_change(samples);
    flip_short_runs(samples, true, rules.shortest);
    if (line.closed) begin_with_a_change(samples);
    const std::vector<Run> runs = runs_of(samples);
    std::vector<LinePart> parts;
    for (const Run& run : runs) {
        if (!run.holds) continue;
        LinePart part{samples[run.begin].place, samples[run.end - 1].place, runs.size() == 1};
        const std::size_t last = samples.size() - 1;
        if (!part.whole && (run.begin > 0 || line.closed))
            part.begin =
                change_between(samples[run.begin > 0 ? run.begin - 1 : last], part.begin, holds);
        if (!part.whole && (run.end <= last || line.closed))
            part.end = change_between(samples[run.end - 1],
                                      samples[run.end <= last ? run.end : 0].place, holds);
        parts.push_back(part);
    }
    return parts;
}

void append_part(const LineSet& from, const Polyline& line, const LinePart& part, double diagonal,
                 LineSet& to) {
    Polyline result = line;
    result.first = std::uint32_t(to.points.size());
    if (part.whole) {
        const auto first = from.points.begin() + line.first;
        to.points.insert(to.points.end(), first, first + line.count);
        to.lines.push_back(result);
        return;
    }
    const std::uint32_t segments = segment_count(line);
    to.points.push_back(point_at(from, line, part.begin));
    const bool runs_over = part.end.segment < part.begin.segment ||
                           (part.end.segment == part.begin.segment && part.end.t < part.begin.t);
    const std::uint32_t between =
        part.end.segment + (runs_over ? segments : 0) - part.begin.segment;
    for (std::uint32_t i = 1; i <= between; ++i)
        to.points.push_back(from.points[line.first + (part.begin.segment + i) % segments]);
    to.points.push_back(point_at(from, line, part.end));
    result.closed = false;
    result.count = std::uint32_t(to.points.size()) - result.first;
    result.length = 0;
    for (std::uint32_t segment = 0; segment + 1 < result.count; ++segment)
        result.length += float(segment_length(to, result, segment) / diagonal);
    to.lines.push_back(result);
}

}  // namespace laplacian_lines
