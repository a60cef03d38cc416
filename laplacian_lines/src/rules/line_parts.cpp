// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/line_parts.h"

#include <algorithm>
#include <cmath>

namespace laplacian_lines {
namespace {

// in √h
constexpr double kAveraging = 2.6;  // to both sides; as wide as a Gaussian of 1.5
constexpr double kStart = 1.5;
constexpr double kContinuation = 6;
constexpr double kHairpin = 0.375;  // to both sides

constexpr float kHairpinCosine = -0.342f;   // of 110°
constexpr float kClearlyConcave = 0.25f;    // cosine
constexpr float kContinuedGradient = 0.5f;  // of the threshold

float finite_or_zero(float v) {
    return std::isfinite(v) ? v : 0;
}

}  // namespace

float concavity_opacity(const LineRules& rules, float concavity) {
    const float least = -rules.fading / 4, range = rules.fading / 2 - least;
    return range > 0 ? std::clamp((concavity - least) / range, 0.f, 1.f) : 1.f;
}

void LinePartFinder::find(const LineRules& rules, const LineCourse& line) {
    parts_.clear();
    addUp(line);
    average(line, kAveraging * double(rules.kernel_size));
    judge(rules, line);
    cutHairpins(line, kHairpin * double(rules.kernel_size));
    const auto left = std::find(states_.begin(), states_.end(), State::Left);
    if (line.closed && left == states_.end()) {
        LinePart whole{0, line.count, true, 0};
        bool starts = false;
        for (std::size_t i = 0; i < points_; ++i) {
            starts = starts || states_[i] == State::Starts;
            whole.slope = std::max(whole.slope, means_[i].slope);
        }
        if (starts) parts_.push_back(whole);
        return;
    }
    // a closed line is followed from where it is not drawn, once around
    const std::size_t first = line.closed ? std::size_t(left - states_.begin()) : 0;
    for (std::size_t i = first; i < first + points_;) {
        if (states_[i % points_] == State::Left) {
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < first + points_ && states_[end % points_] != State::Left)
            ++end;
        addParts(i, end, double(rules.kernel_size));
        i = end;
    }
}

void LinePartFinder::addUp(const LineCourse& line) {
    const std::size_t segments = line.count - 1;
    points_ = line.closed ? segments : line.count;
    offset_ = line.closed ? segments : 0;
    const std::size_t rounds = line.closed ? 3 : 1;
    sums_.resize(rounds * segments + 1);
    Sums sum{0, 0, 0, 0};
    sums_[0] = sum;
    for (std::size_t k = 1; k <= segments; ++k) {
        const float dx = line.x[k] - line.x[k - 1], dy = line.y[k] - line.y[k - 1],
                    dz = line.z[k] - line.z[k - 1];
        const double length = double(std::sqrt(dx * dx + dy * dy + dz * dz));
        const float before = line.gradient[k - 1], after = line.gradient[k];
        sum.length += length;
        sum.slope += length * double(finite_or_zero(line.slope[k]));
        sum.gradient += length * double(before + after) / 2;
        sum.concave += length *
                       double(before * finite_or_zero(line.concavity[k - 1]) +
                              after * finite_or_zero(line.concavity[k])) /
                       2;
        sums_[k] = sum;
    }
    for (std::size_t k = segments + 1; k < sums_.size(); ++k) {
        const Sums& round = sums_[k - segments];
        sums_[k] = {round.length + sum.length, round.slope + sum.slope,
                    round.gradient + sum.gradient, round.concave + sum.concave};
    }
}

double LinePartFinder::lengthBetween(std::size_t from, std::size_t to) const {
    return sums_[to + offset_].length - sums_[from + offset_].length;
}

void LinePartFinder::average(const LineCourse& line, double reach) {
    means_.resize(line.count);
    const double whole = sums_[offset_ + line.count - 1].length - sums_[offset_].length;
    if (line.closed) reach = std::min(reach, whole / 2);
    // the sums at a length along the line; `k` runs ahead of it
    const auto at = [&](double length, std::size_t& k) -> Sums {
        while (k + 1 < sums_.size() && sums_[k].length < length)
            ++k;
        if (k == 0 || sums_[k].length < length) return sums_[k];
        const Sums &a = sums_[k - 1], &b = sums_[k];
        const double step = b.length - a.length, t = step > 0 ? (length - a.length) / step : 1;
        return {length, a.slope + t * (b.slope - a.slope),
                a.gradient + t * (b.gradient - a.gradient),
                a.concave + t * (b.concave - a.concave)};
    };
    std::size_t low = 0, high = 0;
    for (std::size_t i = 0; i < line.count; ++i) {
        const double here = sums_[offset_ + i].length;
        const Sums from = at(std::max(here - reach, 0.), low),
                   to = at(std::min(here + reach, sums_.back().length), high);
        const double length = to.length - from.length, gradient = to.gradient - from.gradient;
        if (!(length > 0) || !(gradient > 0)) {
            means_[i] = {0, 0, 0};
            continue;
        }
        means_[i] = {float((to.slope - from.slope) / length), float(gradient / length),
                     float((to.concave - from.concave) / gradient)};
    }
}

void LinePartFinder::judge(const LineRules& rules, const LineCourse& line) {
    states_.resize(line.count);
    const float concave = rules.concave_only ? kClearlyConcave : -2;
    const float not_convex = rules.concave_only ? -rules.fading / 4 : -2;
    for (std::size_t i = 0; i < line.count; ++i) {
        const Means& m = means_[i];
        const bool continues = m.slope >= rules.segment_slope &&
                               m.gradient >= kContinuedGradient * rules.least_gradient &&
                               m.concavity > not_convex;
        const bool starts = m.slope >= rules.line_slope && m.gradient >= rules.least_gradient &&
                            m.concavity > concave;
        states_[i] = continues && starts ? State::Starts
                     : continues         ? State::Continues
                                         : State::Left;
    }
}

void LinePartFinder::cutHairpins(const LineCourse& line, double reach) {
    const auto point = [&](std::size_t place) {
        return line.closed ? place % points_ : place - offset_;
    };
    std::size_t low = 0, high = 0;
    const std::size_t last = sums_.size() - 1;
    for (std::size_t i = 0; i < points_; ++i) {
        const double here = sums_[offset_ + i].length;
        while (low + 1 <= last && sums_[low + 1].length <= here - reach)
            ++low;
        while (high < last && sums_[high].length < here + reach)
            ++high;
        if (sums_[low].length > here - reach || sums_[high].length < here + reach) continue;
        const std::size_t a = point(low), b = point(high);
        const float bx = line.x[i] - line.x[a], by = line.y[i] - line.y[a],
                    bz = line.z[i] - line.z[a];
        const float ax = line.x[b] - line.x[i], ay = line.y[b] - line.y[i],
                    az = line.z[b] - line.z[i];
        const float product = bx * ax + by * ay + bz * az;
        const float squares = (bx * bx + by * by + bz * bz) * (ax * ax + ay * ay + az * az);
        if (product < kHairpinCosine * std::sqrt(squares)) states_[i] = State::Left;
    }
}

/// Of points [begin, end) that continue, where some start.
void LinePartFinder::addParts(std::size_t begin, std::size_t end, double kernel_size) {
    const double whole = lengthBetween(begin, end - 1);
    const double start = std::min(kStart * kernel_size, whole);
    std::size_t done = begin;  // before it, what belongs to earlier parts
    for (std::size_t i = begin; i < end;) {
        if (states_[i % points_] != State::Starts) {
            ++i;
            continue;
        }
        std::size_t stop = i;
        float slope = 0;
        while (stop < end && states_[stop % points_] == State::Starts)
            slope = std::max(slope, means_[stop++ % points_].slope);
        if (stop - i >= 2 && lengthBetween(i, stop - 1) >= start) {
            std::size_t from = i, to = stop;
            while (from > begin && lengthBetween(from - 1, i) <= kContinuation * kernel_size)
                --from;
            while (to < end && lengthBetween(stop - 1, to) <= kContinuation * kernel_size)
                ++to;
            if (!parts_.empty() && done > begin && from <= done) {
                LinePart& last = parts_.back();
                last.count = to - last.begin;
                last.slope = std::max(last.slope, slope);
            } else {
                parts_.push_back({from, to - from, false, slope});
            }
            done = to;
        }
        i = stop;
    }
}

}  // namespace laplacian_lines
