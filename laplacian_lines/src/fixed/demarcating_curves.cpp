// SPDX-License-Identifier: GPL-3.0-or-later
// Shows demarcating curves that are strong enough, with their weaker continuations.
#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "fixed/demarcation.h"
#include "fixed/fixed_kinds.h"
#include "fixed/strong_lines.h"
#include "rules/line_rules.h"
#include "rules/opacity.h"
#include "rules/thresholds.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr float kFading = 3;  // a gentle relief is paler than a steep one

class DemarcatingCurves : public FixedKindLines {
public:
    explicit DemarcatingCurves(const ExtractorData& data)
        : found_(find_demarcating_curves(data, place_clusters(data))),
          strongest_(strongest_of(found_.lines)) {}

    void append(const ExtractorData& data, FixedLines&, const LocalEye& eye, const LineStyle& style,
                LineSet& lines) const override {
        const std::shared_ptr<const Shown> shown = shown_by(rules_of(style), float(data.diagonal));
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
    static StrongLineRules rules_of(const LineStyle& style) {
        const Thresholds thresholds(style);
        return {thresholds.demarcation, kFading * float(style.fading),
                std::max(kLeastDemarcatingLength, 2 * thresholds.shortest_line),
                kLeastDemarcatingLength, smoothing_passes(style.line_smoothing)};
    }

    /// What the rules show from any eye, before contours hide some.
    struct Shown {
        StrongLineRules rules;
        LineSet lines;
        std::vector<std::uint32_t> places;  // of the points among those that were found
    };

    /// Keeps the last ones: styles seldom change between redraws.
    std::shared_ptr<const Shown> shown_by(const StrongLineRules& rules, float diagonal) const {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!shown_ || !(shown_->rules == rules)) {
            auto shown = std::make_shared<Shown>(Shown{rules, {}, {}});
            const auto note = [&](std::uint32_t place) {
                shown->places.push_back(place);
                return 1.f;
            };
            append_strong(found_.lines, strongest_, rules, diagonal, note, shown->lines);
            shown_ = std::move(shown);
        }
        return shown_;
    }

    const ZeroLines found_;
    const std::vector<float> strongest_;
    mutable std::mutex mutex_;
    mutable std::shared_ptr<const Shown> shown_;
};

}  // namespace

const FixedKind demarcating_curves = fixed_kind<DemarcatingCurves>(LineKind::DemarcatingCurve);

}  // namespace laplacian_lines
