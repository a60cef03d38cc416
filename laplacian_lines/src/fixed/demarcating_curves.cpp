// SPDX-License-Identifier: GPL-3.0-or-later
// Shows of the demarcating curves what is strong enough, with its weaker continuations.
#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "fixed/demarcation.h"
#include "fixed/fixed_kinds.h"
#include "fixed/showing.h"
#include "fixed/stretches.h"
#include "rules/contour_clearance.h"
#include "rules/line_rules.h"
#include "rules/thresholds.h"
#include "system/three_floats.h"

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
        const std::shared_ptr<const Shown> shown = shown_by(Rules(style), float(data.diagonal));
        const float clearance = style.shows[LineKind::Contour] ? float(style.contour_clearance) : 0;
        const auto first = std::uint32_t(lines.points.size());
        for (std::size_t i = 0; i < shown->places.size(); ++i) {
            LinePoint point = shown->lines.points[i];
            const ZeroLines::Form& form = found_.forms[shown->places[i]];
            const Eigen::Vector3f l = eye.towards(form.position);
            point.opacity *=
                clearance_opacity(std::abs(dot(form.normal, l)),
                                  std::max(std::abs(dot(form.bend, l)), 1e-6f), clearance);
            point.weight = point.opacity;
            lines.points.push_back(point);
        }
        for (Polyline line : shown->lines.lines) {
            line.first += first;
            lines.lines.push_back(line);
        }
    }

private:
    struct Rules {
        float demarcation;  ///< degrees
        float fading;
        float least_length;  ///< D
        int smoothing_passes;

        explicit Rules(const LineStyle& style)
            : demarcation(Thresholds(style).demarcation),
              fading(kFading * float(style.fading)),
              least_length(std::max(kLeastDemarcatingLength, 2 * Thresholds(style).shortest_line)),
              smoothing_passes(laplacian_lines::smoothing_passes(style.line_smoothing)) {}

        bool operator==(const Rules& other) const {
            return demarcation == other.demarcation && fading == other.fading &&
                   least_length == other.least_length && smoothing_passes == other.smoothing_passes;
        }
    };

    /// What rules show from any eye, but for what contours take of it.
    struct Shown {
        Rules rules;
        LineSet lines;
        std::vector<std::uint32_t> places;  // of the points among those that were found
    };

    /// The last ones are kept: styles seldom change from one redraw to the next.
    std::shared_ptr<const Shown> shown_by(const Rules& rules, float diagonal) const {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!shown_ || !(shown_->rules == rules)) {
            auto shown = std::make_shared<Shown>(Shown{rules, {}, {}});
            for (std::size_t number = 0; number < found_.lines.lines.size(); ++number)
                append_line(number, diagonal, *shown);
            shown_ = std::move(shown);
        }
        return shown_;
    }

    void append_line(std::size_t number, float diagonal, Shown& shown) const {
        const Polyline& line = found_.lines.lines[number];
        const Rules& rules = shown.rules;
        if (strongest_[number] < rules.demarcation || line.length < rules.least_length) return;
        const LinePoint* points = found_.lines.points.data() + line.first;
        for_each_stretch(line, points, kWeak * rules.demarcation, [&](const Stretch& stretch) {
            const StretchLengths lengths = measure(stretch, points, rules.demarcation, diagonal);
            if (stretch.count >= 2 && lengths.all >= rules.least_length &&
                lengths.strong >= kLeastDemarcatingLength)
                append_stretch(line, stretch, lengths.all, shown);
        });
    }

    void append_stretch(const Polyline& whole, const Stretch& stretch, float length,
                        Shown& shown) const {
        const Rules& rules = shown.rules;
        LineSet& lines = shown.lines;
        Polyline line = whole;
        line.first = std::uint32_t(lines.points.size());
        line.count = stretch.count;
        line.closed = stretch.is_closed;
        line.length = length;
        for (std::uint32_t i = 0; i < stretch.count; ++i) {
            const std::uint32_t place = whole.first + stretch.point(i);
            LinePoint point = found_.lines.points[place];
            point.opacity = angle_opacity(point.gradient, kWeak * rules.demarcation, rules.fading);
            lines.points.push_back(point);
            shown.places.push_back(place);
        }
        smooth_positions(line, lines.points.data() + line.first, rules.smoothing_passes);
        lines.lines.push_back(line);
    }

    mutable std::mutex mutex_;
    mutable std::shared_ptr<const Shown> shown_;
    ZeroLines found_;
    std::vector<float> strongest_;  // the largest value of a line's points, by line
};

}  // namespace

const FixedKind demarcating_curves = fixed_kind<DemarcatingCurves>(LineKind::DemarcatingCurve);

}  // namespace laplacian_lines
