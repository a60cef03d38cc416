// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/strong_lines.h"

#include <algorithm>

#include "fixed/line_copies.h"
#include "fixed/line_smoothing.h"
#include "rules/thresholds.h"
#include "system/chains.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr float kWeak = 0.5f;      // of the least gradient, for continuations of strong parts
constexpr float kSharpAngle = 45;  // degrees; sharper pieces count more than their length
// The ends of a stretch are guesses where more than this share of its points is in triangles so
// many times as long as it is.
constexpr float kMostGuessed = 0.25f, kLongTriangle = 2;

/// In D.
struct StretchLengths {
    float all = 0;
    float strong = 0;  // of the longest part with the least gradient, weighted by sharpness
};

StretchLengths measure(const LinePoint* points, std::uint32_t count, float least, float diagonal) {
    StretchLengths lengths;
    float strong = 0;
    for (std::uint32_t i = 1; i < count; ++i) {
        const LinePoint &a = points[i - 1], &b = points[i];
        const float length = length_of(b.position - a.position) / diagonal;
        lengths.all += length;
        const float sharp = std::min(a.gradient, b.gradient), ratio = sharp / kSharpAngle;
        strong =
            sharp >= least ? strong + std::clamp(ratio * ratio, 1.f, kMostSharpness) * length : 0;
        lengths.strong = std::max(lengths.strong, strong);
    }
    return lengths;
}

float contour_opacity(const ExtractorData& data, const LocalEye& eye, float clearance,
                      const LinePoint& point, const ZeroLines::Sample& sample) {
    const Eigen::Vector3f l = eye.towards(data.local_of(point.position));
    const float facing = std::abs(dot(sample.normal, l)), gradient = std::abs(dot(sample.bend, l));
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
        const std::uint32_t period = point_count(whole);
        const auto is_in = [&](std::size_t i) { return points[i].gradient >= weak; };
        for_each_run(period, whole.closed, is_in, [&](std::size_t begin, std::size_t count) {
            const bool is_all = whole.closed && count == period;
            Polyline& line = append_points(found_.lines, whole, begin, count + is_all, lines);
            LinePoint* const shown = lines.points.data() + line.first;
            const StretchLengths lengths =
                measure(shown, line.count, rules.least, float(data.diagonal));
            const auto place = [&](std::size_t i) { return whole.first + (begin + i) % period; };
            const auto is_guessed = [&] {
                std::uint32_t count = 0;
                for (std::size_t i = 0; i < line.count; ++i)
                    count += found_.samples[place(i)].triangle > kLongTriangle * lengths.all;
                return float(count) > kMostGuessed * float(line.count);
            };
            if (line.count < 2 || lengths.all < rules.least_length ||
                lengths.strong < rules.least_strong || is_guessed()) {
                lines.points.resize(line.first);
                lines.lines.pop_back();
                return;
            }
            line.length = lengths.all;
            for (std::size_t i = 0; i < line.count; ++i) {
                LinePoint& point = shown[i];
                point.opacity = point.weight =
                    left_out && (*left_out)[place(i)]
                        ? 0
                        : rise(point.gradient, weak, weak * (1 + rules.fading)) *
                              contour_opacity(data, eye, rules.clearance, point,
                                              found_.samples[place(i)]);
            }
            smooth_positions(line, shown, rules.smoothing_passes);
        });
    }
}

}  // namespace laplacian_lines
