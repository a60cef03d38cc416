// SPDX-License-Identifier: GPL-3.0-or-later
// Ridges and valleys: the crest lines that are sharp enough, with their weaker continuations.
#include <mutex>

#include "fixed/fixed_lines.h"
#include "fixed/near_lines.h"
#include "fixed/ridge_candidates.h"
#include "fixed/strong_lines.h"
#include "rules/line_rules.h"
#include "rules/thresholds.h"

namespace laplacian_lines {
namespace {

constexpr float kNearCrease = 0.01f;  // D
constexpr float kFading = 5;          // blunt edges are paler than sharp ones
constexpr float kClearance = 4;       // a rounded edge has its contour near its crest

RidgeCandidates find_ridges(const ExtractorData& data, FixedLines& all, Crest crest) {
    RidgeCandidates found = find_ridge_candidates(data, crest);
    measure_ridge_angles(*all.surface(data), crest, found);
    return found;
}

class CrestLines : public FixedKindLines {
public:
    CrestLines(const ExtractorData& data, FixedLines& all, Crest crest)
        : found_(find_ridges(data, all, crest)) {}

    void append(const ExtractorData& data, FixedLines& all, const LocalEye& eye,
                const LineStyle& style, LineSet& lines) const override {
        const Thresholds thresholds(style);
        const float clearance =
            style.shows[LineKind::Contour] ? kClearance * float(style.contour_clearance) : 0;
        const auto along = along_creases(data, all.whole(data, LineKind::Crease, style));
        found_.append(
            data, eye,
            {thresholds.ridge_angle, kFading * float(style.fading), thresholds.shortest_line,
             kLeastRidgeLength, clearance, smoothing_passes(style.line_smoothing)},
            along.get(), lines);
    }

private:
    /// By point, 1 if it only doubles a crease; null if none does.
    std::shared_ptr<const std::vector<std::uint8_t>> along_creases(
        const ExtractorData& data, const std::shared_ptr<const LineSet>& creases) const {
        if (!creases || creases->lines.empty()) return nullptr;
        const std::lock_guard<std::mutex> lock(mutex_);
        if (creases_ != creases) {
            along_ = std::make_shared<const std::vector<std::uint8_t>>(
                points_along(found_.lines(), *creases, kNearCrease * float(data.diagonal)));
            creases_ = creases;
        }
        return along_;
    }

    mutable std::mutex mutex_;
    mutable std::shared_ptr<const LineSet> creases_;  // that along_ belongs to
    mutable std::shared_ptr<const std::vector<std::uint8_t>> along_;
    const StrongLines found_;
};

class Ridges : public CrestLines {
public:
    Ridges(const ExtractorData& data, FixedLines& all) : CrestLines(data, all, kConvexCrest) {}
};

class Valleys : public CrestLines {
public:
    Valleys(const ExtractorData& data, FixedLines& all) : CrestLines(data, all, kConcaveCrest) {}
};

}  // namespace

const FixedKind kRidges = fixed_kind<Ridges>(LineKind::Ridge);
const FixedKind kValleys = fixed_kind<Valleys>(LineKind::Valley);

}  // namespace laplacian_lines
