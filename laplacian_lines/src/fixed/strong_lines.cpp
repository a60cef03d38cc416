// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/strong_lines.h"

#include <algorithm>

#include "fixed/line_smoothing.h"
#include "rules/opacity.h"
#include "rules/runs.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr float kWeak = 0.5f;      // of the least gradient: continues what is stronger
constexpr float kPlainAngle = 45;  // degrees; up to which a piece counts once

/// Successive points of a line; of a closed one they may run over its end.
struct Stretch {
    std::uint32_t first, count;
    std::uint32_t period;  // points of the line, without the copy of a closed one's first
    bool is_closed;        // all of a closed line

    /// The place of point i in the line.
    std::uint32_t point(std::uint32_t i) const { return (first + i) % period; }
};

/// In D.
struct StretchLengths {
    float all = 0;
    float strong = 0;  // of the part that has the gradient, the longest, by sharpness
};

StretchLengths measure(const Stretch& stretch, const LinePoint* points, float least,
                       float diagonal) {
    StretchLengths lengths;
    float strong = 0;
    for (std::uint32_t i = 1; i < stretch.count; ++i) {
        const LinePoint &a = points[stretch.point(i - 1)], &b = points[stretch.point(i)];
        const float length = length_of(b.position - a.position) / diagonal;
        lengths.all += length;
        const float sharp = std::min(a.gradient, b.gradient), ratio = sharp / kPlainAngle;
        strong =
            sharp >= least ? strong + std::clamp(ratio * ratio, 1.f, kMostSharpness) * length : 0;
        lengths.strong = std::max(lengths.strong, strong);
    }
    return lengths;
}

/// From nothing at the angle to full at (1 + fading) times it.
float angle_opacity(float angle, float least_angle, float fading) {
    if (angle < least_angle) return 0;
    const float range = least_angle * fading;
    return range > 0 ? std::min((angle - least_angle) / range, 1.f) : 1.f;
}

/// Of a point beside contours.
float contour_opacity(const ExtractorData& data, const LocalEye& eye, float clearance,
                      const LinePoint& point, const ZeroLines::Form& form) {
    const Eigen::Vector3f l = eye.towards(data.local_of(point.position));
    const float facing = std::abs(dot(form.normal, l)), gradient = std::abs(dot(form.bend, l));
    return clearance_opacity(facing, std::max(gradient, 1e-6f), clearance);
}

}  // namespace

StrongLines::StrongLines(ZeroLines found) : found_(std::move(found)) {
    for (const Polyline& line : found_.lines.lines) {
        float most = 0;
        for (std::uint32_t i = 0; i < line.count; ++i)
            most = std::max(most, found_.lines.points[line.first + i].gradient);
        strongest_.push_back(most);
    }
}

void StrongLines::append(const ExtractorData& data, const LocalEye& eye,
                         const StrongLineRules& rules, const std::vector<std::uint8_t>* left_out,
                         LineSet& lines) const {
    const float weak = kWeak * rules.least;
    for (std::size_t number = 0; number < strongest_.size(); ++number) {
        const Polyline& whole = found_.lines.lines[number];
        if (strongest_[number] < rules.least || whole.length < rules.least_length) continue;
        const LinePoint* points = found_.lines.points.data() + whole.first;
        const std::uint32_t period = whole.closed ? whole.count - 1 : whole.count;
        const auto is_in = [&](std::size_t i) { return points[i].gradient >= weak; };
        for_each_run(period, whole.closed, is_in, [&](std::size_t begin, std::size_t count) {
            const bool is_all = whole.closed && count == period;
            const Stretch stretch{std::uint32_t(begin), std::uint32_t(count) + is_all, period,
                                  is_all};
            const StretchLengths lengths =
                measure(stretch, points, rules.least, float(data.diagonal));
            if (stretch.count < 2 || lengths.all < rules.least_length ||
                lengths.strong < rules.least_strong)
                return;
            Polyline line = whole;
            line.first = std::uint32_t(lines.points.size());
            line.count = stretch.count;
            line.closed = stretch.is_closed;
            line.length = lengths.all;
            for (std::uint32_t i = 0; i < stretch.count; ++i) {
                const std::uint32_t place = whole.first + stretch.point(i);
                LinePoint point = found_.lines.points[place];
                point.opacity = point.weight =
                    left_out && (*left_out)[place]
                        ? 0
                        : angle_opacity(point.gradient, weak, rules.fading) *
                              contour_opacity(data, eye, rules.clearance, point,
                                              found_.forms[place]);
                lines.points.push_back(point);
            }
            smooth_positions(line, lines.points.data() + line.first, rules.smoothing_passes);
            lines.lines.push_back(line);
        });
    }
}

}  // namespace laplacian_lines
