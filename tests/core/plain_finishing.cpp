// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_extraction.h"

#include <algorithm>

namespace reference {

using namespace laplacian_lines;

namespace {

/// In place of the point beyond an open end.
enum class LineEnd {
    Repeated,   ///< the last value again: values change evenly up to the end
    Reflected,  ///< the point before it, mirrored in the end: ends stay where they are
};

/// One binomial pass (1-2-1) over a member of the line's points; a closed line's first and last
/// stay equal.
template <class Value>
void smooth_line(const Polyline& line, LinePoint* points, Value LinePoint::*value, LineEnd end) {
    const std::uint32_t last = line.count - 1;
    const auto beyond = [&](const Value& here, const Value& inner) -> Value {
        return end == LineEnd::Repeated ? here : Value(2 * here - inner);
    };
    const Value second = points[1].*value;
    Value before = line.closed ? points[last - 1].*value : beyond(points[0].*value, second);
    for (std::uint32_t i = 0; i <= last; ++i) {
        const Value here = points[i].*value;
        const Value after = i < last      ? points[i + 1].*value
                            : line.closed ? second
                                          : beyond(here, before);
        points[i].*value = (before + 2 * here + after) / 4;
        before = here;
    }
}

constexpr int kTaperingPasses = 2;  // slopes of neighbouring triangles differ visibly

/// 0 at the threshold, 1 at (1 + fading) times it; 1 without threshold.
float above(float value, float threshold, float fading) {
    const float range = threshold * fading;
    return range > 0 ? std::clamp((value - threshold) / range, 0.f, 1.f) : 1.f;
}

void slopes_to_means(const Polyline& line, LinePoint* points) {
    const std::uint32_t last = line.count - 1;
    if (line.closed) {  // the first point and its copy share their two segments
        points[0].weight += points[last].weight;
        points[last].weight = points[0].weight;
    }
    for (std::uint32_t i = 0; i <= last; ++i)
        if (line.closed || (i > 0 && i < last)) points[i].weight /= 2;
}

void segments_to_means(const Polyline& line, LinePoint* points) {
    const std::uint32_t last = line.count - 1;
    points[0].weight = points[line.closed ? last : 1].weight;
    const float beyond = points[line.closed ? 1 : last].weight;
    for (std::uint32_t i = 0; i <= last; ++i)
        points[i].weight = (points[i].weight + (i < last ? points[i + 1].weight : beyond)) / 2;
}

/// Over `length`.
void fade_ends(const Polyline& line, float length, const bool ends_unseen[2], LinePoint* points) {
    if (line.closed || !(length > 0)) return;
    const auto fade = [&](LinePoint* from, LinePoint* to, int step) {
        float distance = 0;
        Eigen::Vector3f before = from->position;
        for (LinePoint* p = from; distance < length; p += step) {
            distance += (p->position - before).norm();
            before = p->position;
            p->opacity *= std::min(distance / length, 1.f);
            if (p == to) return;
        }
    };
    LinePoint* last = points + line.count - 1;
    if (!ends_unseen[0]) fade(points, last, 1);
    if (!ends_unseen[1]) fade(last, points, -1);
}

void taper_line(const LineRules& rules, const Polyline& line, LinePoint* points) {
    if (!rules.use_slope) {
        for (std::uint32_t i = 0; i < line.count; ++i) {
            points[i].weight = points[i].opacity;
            points[i].opacity = 1;
        }
        for (int pass = 0; pass < kTaperingPasses; ++pass)
            smooth_line(line, points, &LinePoint::weight, LineEnd::Repeated);
        return;
    }
    if (rules.whole)
        segments_to_means(line, points);
    else
        slopes_to_means(line, points);
    const bool ends_unseen[2] = {points[0].opacity == 0, points[line.count - 1].opacity == 0};
    // A line that barely passes is barely seen, so that it does not pop up when the view turns.
    const float by_slope = above(line.slope, rules.line_slope, rules.fading);
    const float whole = std::min({by_slope, above(line.length, rules.least_length, rules.fading),
                                  above(line.strength, rules.least_strength, rules.fading)});
    for (std::uint32_t i = 0; i < line.count; ++i) {
        LinePoint& p = points[i];
        p.opacity *= whole * above(p.weight, rules.segment_slope, rules.fading);
        p.weight = std::clamp((p.weight - rules.segment_slope) / rules.full_slope, 0.f, 1.f);
    }
    for (int pass = 0; pass < kTaperingPasses; ++pass) {
        smooth_line(line, points, &LinePoint::weight, LineEnd::Repeated);
        smooth_line(line, points, &LinePoint::opacity, LineEnd::Repeated);
    }
    fade_ends(line, rules.end_length, ends_unseen, points);
}

}  // namespace

void finish_plainly(const LineRules& rules, const Polyline& line, const Eigen::Vector3d& centre,
                    double diagonal, LinePoint* points) {
    taper_line(rules, line, points);
    for (int pass = 0; pass < rules.smoothing_passes; ++pass)
        smooth_line(line, points, &LinePoint::position, LineEnd::Reflected);
    for (std::uint32_t i = 0; i < line.count; ++i)
        points[i].position = (centre + diagonal * points[i].position.cast<double>()).cast<float>();
}

}  // namespace reference
