// SPDX-License-Identifier: GPL-3.0-or-later
// Ridges and valleys: shows of the crest lines what is sharp enough, with its weaker continuations.
#include <algorithm>
#include <mutex>

#include "fixed/fixed_kinds.h"
#include "fixed/fixed_lines.h"
#include "fixed/near_lines.h"
#include "fixed/ridge_angles.h"
#include "fixed/showing.h"
#include "fixed/stretches.h"
#include "rules/contour_clearance.h"
#include "rules/line_rules.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr float kWeak = 0.5f;         // of the style's angle: continues what is sharper
constexpr float kNearCrease = 0.01f;  // D
constexpr float kFading = 5;          // a soft edge is paler than a sharp one

struct RidgeRules {
    float angle;  ///< degrees
    float fading;
    float clearance, least_length;  ///< D
    int smoothing_passes;

    explicit RidgeRules(const LineStyle& style)
        : angle(Thresholds(style).ridge_angle),
          fading(kFading * float(style.fading)),
          // The contour of a rounded edge stays near its crest for long.
          clearance(style.shows[LineKind::Contour] ? 4 * float(style.contour_clearance) : 0),
          least_length(Thresholds(style).shortest_line),
          smoothing_passes(laplacian_lines::smoothing_passes(style.line_smoothing)) {}
};

class CrestLines : public FixedKindLines {
public:
    CrestLines(const ExtractorData& data, Crest crest) {
        const std::vector<PlacedCluster> placed = place_clusters(data);
        found_ = find_ridge_candidates(data, placed, crest);
        measure_ridge_angles(data, placed, crest, found_);
        for (const Polyline& line : found_.lines.lines) {
            const LinePoint* points = found_.lines.points.data() + line.first;
            sharpest_.push_back(std::max_element(points, points + line.count,
                                                 [](const LinePoint& a, const LinePoint& b) {
                                                     return a.gradient < b.gradient;
                                                 })
                                    ->gradient);
        }
    }

    void append(const ExtractorData& data, FixedLines& all, const LocalEye& eye,
                const LineStyle& style, LineSet& lines) const override {
        const RidgeRules rules(style);
        const auto along = along_creases(data, all.whole(data, LineKind::Crease, style));
        for (std::size_t number = 0; number < found_.lines.lines.size(); ++number) {
            const Polyline& line = found_.lines.lines[number];
            if (sharpest_[number] < rules.angle || line.length < rules.least_length) continue;
            for_each_stretch(line, found_.lines.points.data() + line.first, kWeak * rules.angle,
                             [&](const Stretch& stretch) {
                                 append_stretch(data, eye, rules, line, stretch, along.get(),
                                                lines);
                             });
        }
    }

private:
    void append_stretch(const ExtractorData& data, const LocalEye& eye, const RidgeRules& rules,
                        const Polyline& whole, const Stretch& stretch,
                        const std::vector<std::uint8_t>* along, LineSet& lines) const {
        const LinePoint* points = found_.lines.points.data() + whole.first;
        const StretchLengths lengths = measure(stretch, points, rules.angle, float(data.diagonal));
        if (stretch.count < 2 || lengths.all < rules.least_length ||
            lengths.strong < kLeastRidgeLength)
            return;
        Polyline line = whole;
        line.first = std::uint32_t(lines.points.size());
        line.count = stretch.count;
        line.closed = stretch.is_closed;
        line.length = lengths.all;
        for (std::uint32_t i = 0; i < stretch.count; ++i) {
            LinePoint point = points[stretch.point(i)];
            const std::uint32_t place = whole.first + stretch.point(i);
            point.opacity = point.weight =
                along && (*along)[place]
                    ? 0
                    : angle_opacity(point.gradient, kWeak * rules.angle, rules.fading) *
                          clearance(data, eye, rules, point, found_.forms[place]);
            lines.points.push_back(point);
        }
        smooth_positions(line, lines.points.data() + line.first, rules.smoothing_passes);
        lines.lines.push_back(line);
    }

    static float clearance(const ExtractorData& data, const LocalEye& eye, const RidgeRules& rules,
                           const LinePoint& point, const RidgeCandidates::Form& form) {
        const Eigen::Vector3f l = eye.towards(
            ((point.position.cast<double>() - data.centre) / data.diagonal).cast<float>());
        const float facing = std::abs(dot(form.normal, l)), gradient = std::abs(dot(form.bend, l));
        return clearance_opacity(facing, std::max(gradient, 1e-6f), rules.clearance);
    }

    /// Which points only double creases; null if none does.
    std::shared_ptr<const std::vector<std::uint8_t>> along_creases(
        const ExtractorData& data, const std::shared_ptr<const LineSet>& creases) const {
        if (!creases || creases->lines.empty()) return nullptr;
        const std::lock_guard<std::mutex> lock(mutex_);
        if (creases_ != creases) {
            const NearLines near(*creases, kNearCrease * float(data.diagonal));
            along_ =
                std::make_shared<const std::vector<std::uint8_t>>(points_along(found_.lines, near));
            creases_ = creases;
        }
        return along_;
    }

    mutable std::mutex mutex_;
    mutable std::shared_ptr<const LineSet> creases_;  // that along_ belongs to
    mutable std::shared_ptr<const std::vector<std::uint8_t>> along_;
    RidgeCandidates found_;
    std::vector<float> sharpest_;  // the largest angle of a line's points, by line
};

class Ridges : public CrestLines {
public:
    explicit Ridges(const ExtractorData& data) : CrestLines(data, kConvexCrest) {}
};

class Valleys : public CrestLines {
public:
    explicit Valleys(const ExtractorData& data) : CrestLines(data, kConcaveCrest) {}
};

}  // namespace

const FixedKind ridges = fixed_kind<Ridges>(LineKind::Ridge);
const FixedKind valleys = fixed_kind<Valleys>(LineKind::Valley);

}  // namespace laplacian_lines
