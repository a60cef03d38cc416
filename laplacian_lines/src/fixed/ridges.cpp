// SPDX-License-Identifier: GPL-3.0-or-later
// Ridges and valleys: the crest lines that are sharp enough, with their weaker continuations; but
// not where they run beside creases.
#include <algorithm>
#include <mutex>

#include "fixed/fixed_lines.h"
#include "fixed/ridge_candidates.h"
#include "fixed/strong_lines.h"
#include "mesh/box_tree.h"
#include "rules/line_rules.h"
#include "rules/thresholds.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;

constexpr float kNearCrease = 0.01f;  // D
constexpr float kAlong = 0.5f;        // least squared cosine of lines that run beside each other
constexpr float kThrough = 0.5f;      // likewise of the way through a wall and the normal there
constexpr float kSamePlace = 0.01f;   // of kNearCrease²; what is less far below is on this side
constexpr float kRoundUp = 1.01f;     // of boxes, which only preselect
// Times those of the style.
constexpr float kFading = 5;     // blunt edges are paler than sharp ones
constexpr float kClearance = 4;  // a rounded edge has its contour near its crest

/// Whether a piece passes within the distance of p, about in this direction, and not behind the
/// wall that p is on: below p, along the unit normal there. A zero normal: whichever side.
bool is_along(const Vector3f& begin, const Vector3f& end, float distance, const Vector3f& p,
              const Vector3f& direction, const Vector3f& normal) {
    const Vector3f span = end - begin;
    const float length = squared_length_of(span), squared = squared_length_of(direction);
    const float t = length > 0 ? std::clamp(dot(p - begin, span) / length, 0.f, 1.f) : 0.f;
    const Vector3f aside = begin + t * span - p;
    const float far = distance * distance;
    if (squared_length_of(aside) > far) return false;
    const float below = dot(aside, normal), ahead = dot(aside, direction);
    const float across = squared_length_of(aside) * squared - ahead * ahead;
    if (below < 0 && below * below > kSamePlace * far &&
        below * below * squared > kThrough * across)
        return false;
    const float product = dot(span, direction);
    return product * product >= kAlong * length * squared;
}

/// For each point of the ridges, 1 if a line of `others` runs beside it: within the distance, in
/// the points' unit, and at less than 45 degrees. Any number of threads gives the same.
std::vector<std::uint8_t> points_along(const ZeroLines& ridges, const Crest& crest,
                                       const LineSet& others, float distance) {
    const LineSet& lines = ridges.lines;
    std::vector<std::uint32_t> begins;  // points from which pieces go to the next
    Eigen::AlignedBox3f bounds;
    for (const Polyline& line : others.lines)
        for (std::uint32_t i = line.first; i + 1 < line.first + line.count; ++i)
            begins.push_back(i);
    for (const LinePoint& point : others.points)
        bounds.extend(point.position);
    const auto at = [&](std::uint32_t i) -> const Vector3f& { return others.points[i].position; };
    const auto tree = BoxTree<3>::along_curve(std::move(begins), bounds, [&](std::uint32_t begin) {
        const Vector3f room = Vector3f::Constant(kRoundUp * distance);
        const Vector3f &a = at(begin), &b = at(begin + 1);
        return Eigen::AlignedBox3f(a.cwiseMin(b) - room, a.cwiseMax(b) + room);
    });
    std::vector<std::uint8_t> along(lines.points.size(), 0);
    in_parallel(lines.lines.size(), [&](std::size_t number) {
        const Polyline& line = lines.lines[number];
        const LinePoint* points = lines.points.data() + line.first;
        for (std::uint32_t i = 0; i < line.count; ++i) {
            const Vector3f& p = points[i].position;
            const Vector3f direction = points[std::min(i + 1, line.count - 1)].position -
                                       points[i > 0 ? i - 1 : 0].position;
            const Vector3f normal = crest.sign > 0 ? unit(ridges.samples[line.first + i].normal)
                                                   : Vector3f(Vector3f::Zero());
            along[line.first + i] = !tree.visit(Eigen::AlignedBox3f(p), [&](std::uint32_t begin) {
                return !is_along(at(begin), at(begin + 1), distance, p, direction, normal);
            });
        }
    });
    return along;
}

template <const Crest& crest>
class CrestLines : public FixedKindLines {
public:
    CrestLines(const ExtractorData& data, FixedLines& all) : found_(find(data, all)) {}

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
    static ZeroLines find(const ExtractorData& data, FixedLines& all) {
        ZeroLines found = find_ridge_candidates(data, crest);
        measure_ridge_angles(*all.surface(data), crest, found);
        return found;
    }

    /// By point, 1 if it only doubles a crease; null without creases.
    std::shared_ptr<const std::vector<std::uint8_t>> along_creases(
        const ExtractorData& data, const std::shared_ptr<const LineSet>& creases) const {
        if (!creases || creases->lines.empty()) return nullptr;
        const std::lock_guard<std::mutex> lock(mutex_);
        if (creases_ != creases) {
            along_ = std::make_shared<const std::vector<std::uint8_t>>(
                points_along(found_.all(), crest, *creases, kNearCrease * float(data.diagonal)));
            creases_ = creases;
        }
        return along_;
    }

    mutable std::mutex mutex_;
    mutable std::shared_ptr<const LineSet> creases_;  // that along_ belongs to
    mutable std::shared_ptr<const std::vector<std::uint8_t>> along_;
    const StrongLines found_;
};

}  // namespace

const FixedKind kRidges = fixed_kind<CrestLines<kConvexCrest>>(LineKind::Ridge);
const FixedKind kValleys = fixed_kind<CrestLines<kConcaveCrest>>(LineKind::Valley);

}  // namespace laplacian_lines
