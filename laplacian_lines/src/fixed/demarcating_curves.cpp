// SPDX-License-Identifier: GPL-3.0-or-later
// Shows of the demarcating curves what is strong enough, with its weaker continuations.
#include <algorithm>
#include <cmath>

#include "fixed/demarcation.h"
#include "fixed/fixed_kinds.h"
#include "fixed/showing.h"
#include "fixed/stretches.h"
#include "rules/contour_clearance.h"
#include "rules/line_rules.h"

namespace laplacian_lines {
namespace {

constexpr float kWeak = 0.5f;  // of the style's demarcation: continues what is stronger
constexpr float kFading = 3;   // a gentle relief is paler than a steep one

class DemarcatingCurves : public FixedKindLines {
public:
    explicit DemarcatingCurves(const ExtractorData& data)
        : found_(find_demarcating_curves(data, place_clusters(data))) {
        for (const Polyline& line : found_.lines.lines) {
            const LinePoint* points = found_.lines.points.data() + line.first;
            float most = 0;
            for (std::uint32_t i = 0; i < line.count; ++i)
                most = std::max(most, points[i].gradient);
            strongest_.push_back(most);
        }
    }

    void append(const ExtractorData& data, FixedLines&, const LocalEye& eye, const LineStyle& style,
                LineSet& lines) const override {
        const Rules rules(style);
        for (std::size_t number = 0; number < found_.lines.lines.size(); ++number) {
            const Polyline& line = found_.lines.lines[number];
            if (strongest_[number] < rules.demarcation || line.length < rules.least_length)
                continue;
            const LinePoint* points = found_.lines.points.data() + line.first;
            for_each_stretch(line, points, kWeak * rules.demarcation, [&](const Stretch& stretch) {
                append_stretch(data, eye, rules, line, stretch, lines);
            });
        }
    }

private:
    struct Rules {
        float demarcation;  ///< degrees
        float fading;
        float clearance, least_length;  ///< D
        int smoothing_passes;

        explicit Rules(const LineStyle& style)
            : demarcation(float(threshold_factor(style.detail) * style.demarcation)),
              fading(kFading * float(style.fading)),
              clearance(style.shows[LineKind::Contour] ? float(style.contour_clearance) : 0),
              least_length(std::max(kLeastDemarcatingLength, 2 * shortest_line(style))),
              smoothing_passes(laplacian_lines::smoothing_passes(style.line_smoothing)) {}
    };

    void append_stretch(const ExtractorData& data, const LocalEye& eye, const Rules& rules,
                        const Polyline& whole, const Stretch& stretch, LineSet& lines) const {
        const LinePoint* points = found_.lines.points.data() + whole.first;
        const StretchLengths lengths =
            measure(stretch, points, rules.demarcation, float(data.diagonal));
        if (stretch.count < 2 || lengths.all < rules.least_length ||
            lengths.strong < kLeastDemarcatingLength)
            return;
        Polyline line = whole;
        line.first = std::uint32_t(lines.points.size());
        line.count = stretch.count;
        line.closed = stretch.is_closed;
        line.length = lengths.all;
        for (std::uint32_t i = 0; i < stretch.count; ++i) {
            LinePoint point = points[stretch.point(i)];
            const ZeroLines::Form& form = found_.forms[whole.first + stretch.point(i)];
            const Eigen::Vector3f l = eye.towards(form.position);
            point.opacity = point.weight =
                angle_opacity(point.gradient, kWeak * rules.demarcation, rules.fading) *
                clearance_opacity(std::abs(form.normal.dot(l)),
                                  std::max(std::abs(form.bend.dot(l)), 1e-6f), rules.clearance);
            lines.points.push_back(point);
        }
        smooth_positions(line, lines.points.data() + line.first, rules.smoothing_passes);
        lines.lines.push_back(line);
    }

    ZeroLines found_;
    std::vector<float> strongest_;  // the largest value of a line's points, by line
};

}  // namespace

const FixedKind demarcating_curves = fixed_kind<DemarcatingCurves>(LineKind::DemarcatingCurve);

}  // namespace laplacian_lines
