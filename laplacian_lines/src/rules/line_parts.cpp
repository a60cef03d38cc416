// SPDX-License-Identifier: GPL-3.0-or-later
// Sums from the first piece on, so that the mean between any two places of a line is a difference
// of two of them, whatever the reach. At each knot the means over the reach say how clearly the
// line is seen; parts are runs of pieces of which something is seen.
#include "rules/line_parts.h"

#include <algorithm>
#include <cmath>

#include "rules/thresholds.h"
#include "system/chains.h"

namespace laplacian_lines {
namespace {

constexpr double kAveraging = 1.5, kAveragingUncut = 2;  // √h, to both sides
constexpr double kLeastKernel = 1e-6;                    // D; of synthetic fields

double finite_or_zero(float v) {
    return std::isfinite(v) ? double(v) : 0;
}

}  // namespace

void LinePartFinder::find(const LineRules& rules, const std::vector<LinePiece>& pieces,
                          bool closed) {
    closed_ = closed;
    add_up(pieces);
    const double reach = is_cut_by_convex(rules) ? kAveraging : kAveragingUncut;
    judge(rules, reach * std::max(double(rules.kernel_size), kLeastKernel));
    collect_parts();
}

void LinePartFinder::add_up(const std::vector<LinePiece>& pieces) {
    pieces_ = pieces.size();
    offset_ = closed_ ? pieces_ : 0;
    sums_.resize((closed_ ? 3 : 1) * pieces_ + 1);
    Sums sum{0, 0, 0, 0};
    sums_[0] = sum;
    for (std::size_t k = 1; k < sums_.size(); ++k) {
        const LinePiece& piece = pieces[(k - 1) % pieces_];
        sum.length += finite_or_zero(piece.length);
        sum.slope += finite_or_zero(piece.slope);
        sum.gradient += finite_or_zero(piece.gradient);
        sum.concave += finite_or_zero(piece.concave);
        sums_[k] = sum;
    }
}

LinePartFinder::Sums LinePartFinder::sums_at(double length, std::size_t& k) const {
    while (k + 1 < sums_.size() && sums_[k].length < length)
        ++k;
    if (k == 0 || sums_[k].length < length) return sums_[k];
    const Sums &a = sums_[k - 1], &b = sums_[k];
    const double step = b.length - a.length, t = step > 0 ? (length - a.length) / step : 1;
    return {length, a.slope + t * (b.slope - a.slope), a.gradient + t * (b.gradient - a.gradient),
            a.concave + t * (b.concave - a.concave)};
}

void LinePartFinder::judge(const LineRules& rules, double reach) {
    slopes_.assign(pieces_ + 1, 0.f);
    seen_.assign(pieces_ + 1, 0.f);
    const double whole = sums_[offset_ + pieces_].length - sums_[offset_].length;
    if (closed_) reach = std::min(reach, whole / 2);
    const float over = 1 + rules.fading;
    std::size_t low = 0, high = 0;
    for (std::size_t i = 0; i <= pieces_; ++i) {
        const double here = sums_[offset_ + i].length;
        const Sums from = sums_at(std::max(here - reach, 0.), low),
                   to = sums_at(std::min(here + reach, sums_.back().length), high);
        const double length = to.length - from.length, gradient = to.gradient - from.gradient;
        if (!(length > 0) || !(gradient > 0)) continue;
        slopes_[i] = float((to.slope - from.slope) / length);
        seen_[i] = std::min(
            rise(slopes_[i], rules.segment_slope, rules.segment_slope * over),
            rise(float(gradient / length), rules.least_gradient / over, rules.least_gradient));
        if (rules.concave_only)
            seen_[i] = std::min(seen_[i], rise(float((to.concave - from.concave) / gradient),
                                               -rules.fading / 4, rules.fading / 2));
    }
}

void LinePartFinder::collect_parts() {
    parts_.clear();
    const auto is_seen = [&](std::size_t piece) {
        return seen_[piece] > 0 || seen_[piece + 1] > 0;
    };
    for_each_run(pieces_, closed_, is_seen, [&](std::size_t begin, std::size_t count) {
        parts_.push_back({begin, count, closed_ && count == pieces_});
    });
}

}  // namespace laplacian_lines
