// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/strong_lines.h"

#include <algorithm>

#include "fixed/line_copies.h"
#include "fixed/line_smoothing.h"
#include "fixed/surface_walk.h"
#include "rules/thresholds.h"
#include "system/chains.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr float kWeak = 0.5f;      // of the least gradient, for continuations of strong parts
constexpr float kSharpAngle = 45;  // degrees; sharper pieces count more than their length
// Within a large triangle the place of a line is a guess, except along the narrow strips of a
// rounded edge.
constexpr float kLongPiece = 0.06f, kHighStrip = 0.01f;  // D
// Longest sides, in lengths of the stretch: of triangles within which all of the stretch is a
// guess, and of strips that it may follow from end to end.
constexpr float kLongTriangle = 2, kWholeStrip = 1.1f;
constexpr float kMostGuessed = 0.25f;  // of the length of a stretch

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

float distance(const ZeroLines::Sample& a, const ZeroLines::Sample& b) {
    return length_of(b.position - a.position);
}

/// The length of what is a guess of a stretch of `all`, D. `sample(i)`: at its points.
template <class SampleAt>
float guessed_length(const LinePoint* points, std::uint32_t count, const SampleAt& sample,
                     float all) {
    float guessed = 0;
    for (std::uint32_t i = 1; i < count; ++i) {
        const ZeroLines::Sample &a = sample(i - 1), &b = sample(i);
        const float length = distance(a, b);
        const float triangle = std::min(a.triangle, b.triangle);
        const bool is_edge = std::min(points[i - 1].gradient, points[i].gradient) >= kEdgeAngle &&
                             std::min(a.height, b.height) <= kHighStrip &&
                             triangle <= kWholeStrip * all;
        if (triangle > kLongTriangle * all || (length > kLongPiece && !is_edge)) guessed += length;
    }
    return guessed;
}

float contour_opacity(const ExtractorData& data, const LocalEye& eye, float clearance,
                      const LinePoint& point, const ZeroLines::Sample& sample) {
    const Eigen::Vector3f l = eye.towards(data.local_of(point.position));
    const float facing = std::abs(dot(sample.normal, l)), gradient = std::abs(dot(sample.bend, l));
    return clearance_opacity(facing, std::max(gradient, 1e-6f), clearance);  // not 0
}

}  // namespace

StrongLines::StrongLines(ZeroLines found) : found_(std::move(found)) {
    const std::vector<ZeroLines::Sample>& samples = found_.samples;
    for (const Polyline& line : found_.lines.lines) {
        Largest& largest = largest_.emplace_back();
        for (std::uint32_t i = line.first; i < line.first + line.count; ++i) {
            largest.gradient = std::max(largest.gradient, found_.lines.points[i].gradient);
            largest.triangle = std::max(largest.triangle, samples[i].triangle);
            if (i > line.first)
                largest.piece = std::max(largest.piece, distance(samples[i - 1], samples[i]));
        }
    }
}

void StrongLines::append(const ExtractorData& data, const LocalEye& eye,
                         const StrongLineRules& rules, const std::vector<std::uint8_t>* left_out,
                         LineSet& lines) const {
    const float weak = kWeak * rules.least;
    for (std::size_t number = 0; number < largest_.size(); ++number) {
        const Polyline& whole = found_.lines.lines[number];
        const Largest& largest = largest_[number];
        if (largest.gradient < rules.least || whole.length < rules.least_length) continue;
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
            const auto sample = [&](std::size_t i) -> const ZeroLines::Sample& {
                return found_.samples[place(i)];
            };
            const bool may_guess =
                largest.piece > kLongPiece || largest.triangle > kLongTriangle * lengths.all;
            if (line.count < 2 || lengths.all < rules.least_length ||
                lengths.strong < rules.least_strong ||
                (may_guess && guessed_length(shown, line.count, sample, lengths.all) >
                                  kMostGuessed * lengths.all)) {
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
                              contour_opacity(data, eye, rules.clearance, point, sample(i));
            }
            smooth_positions(line, shown, rules.smoothing_passes);
        });
    }
}

}  // namespace laplacian_lines
