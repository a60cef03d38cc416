// SPDX-License-Identifier: GPL-3.0-or-later
// Ridges and valleys: shows of the crest lines what is sharp enough, with its weaker continuations.
#include <algorithm>
#include <mutex>

#include "fixed/fixed_kinds.h"
#include "fixed/fixed_lines.h"
#include "fixed/near_lines.h"
#include "fixed/ridge_candidates.h"
#include "fixed/strong_lines.h"
#include "rules/line_rules.h"
#include "rules/opacity.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr float kNearCrease = 0.01f;  // D
constexpr float kFading = 5;          // a soft edge is paler than a sharp one
constexpr float kClearance = 4;       // the contour of a rounded edge stays near its crest for long

class CrestLines : public FixedKindLines {
public:
    CrestLines(const ExtractorData& data, Crest crest) {
        const std::vector<PlacedCluster> placed = place_clusters(data);
        found_ = find_ridge_candidates(data, placed, crest);
        measure_ridge_angles(data, crest, found_);
        sharpest_ = strongest_of(found_.lines);
    }

    void append(const ExtractorData& data, FixedLines& all, const LocalEye& eye,
                const LineStyle& style, LineSet& lines) const override {
        const Thresholds thresholds(style);
        const StrongLineRules rules{thresholds.ridge_angle, kFading * float(style.fading),
                                    thresholds.shortest_line, kLeastRidgeLength,
                                    smoothing_passes(style.line_smoothing)};
        const float clear =
            style.shows[LineKind::Contour] ? kClearance * float(style.contour_clearance) : 0;
        const auto along = along_creases(data, all.whole(data, LineKind::Crease, style));
        const auto share_of = [&](std::uint32_t place) {
            return along && (*along)[place] ? 0 : clearance(data, eye, clear, place);
        };
        append_strong(found_.lines, sharpest_, rules, float(data.diagonal), share_of, lines);
    }

private:
    /// By a contour that is nearer than `clear`.
    float clearance(const ExtractorData& data, const LocalEye& eye, float clear,
                    std::uint32_t place) const {
        const LinePoint& point = found_.lines.points[place];
        const RidgeCandidates::Form& form = found_.forms[place];
        const Eigen::Vector3f l = eye.towards(
            ((data.origin - data.centre + point.position.cast<double>()) / data.diagonal)
                .cast<float>());
        const float facing = std::abs(dot(form.normal, l)), gradient = std::abs(dot(form.bend, l));
        return clearance_opacity(facing, std::max(gradient, 1e-6f), clear);
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
