// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/line_parts.h"

#include <algorithm>
#include <cmath>

namespace laplacian_lines {
namespace {

// in √h
constexpr double kAveraging = 2.6;  // to both sides; as wide as a Gaussian of 1.5
constexpr double kContinuation = 6;
constexpr double kHairpin = 0.375;  // to both sides

constexpr double kLeastKernel = 1e-6;  // D; of fields that are made up

constexpr float kHairpinCosine = -0.342f;   // of 110°
constexpr float kClearConcavity = 0.25f;    // cosine
constexpr float kContinuedGradient = 0.5f;  // of the threshold

float finite_or_zero(float v) {
    return std::isfinite(v) ? v : 0;
}

/// 0 at `from`, 1 from `to` on; a step there if they are equal.
float rise(float v, float from, float to) {
    if (v >= to) return 1;
    return v > from ? (v - from) / (to - from) : 0;
}

}  // namespace

void LinePartFinder::find(const LineRules& rules, const LineCourse& line) {
    const double size = std::max(double(rules.kernel_size), kLeastKernel);
    addUp(line);
    average(line, kAveraging * size);
    judge(rules, line);
    fadeAtHairpins(line, kHairpin * size);
    spread(line, kContinuation * size);
    collectParts(line);
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
    continues_.resize(line.count);
    starts_.resize(line.count);
    const float over = 1 + rules.fading, convex = -rules.fading / 4;
    for (std::size_t i = 0; i < line.count; ++i) {
        const Means& m = means_[i];
        float continues = std::min(rise(m.slope, rules.segment_slope, rules.segment_slope * over),
                                   rise(m.gradient, kContinuedGradient * rules.least_gradient,
                                        kContinuedGradient * rules.least_gradient * over));
        float starts =
            std::min(rise(m.slope, rules.line_slope, rules.line_slope * over),
                     rise(m.gradient, rules.least_gradient, rules.least_gradient * over));
        if (rules.concave_only) {
            continues = std::min(continues, rise(m.concavity, convex, -2 * convex));
            starts = std::min(starts, rise(m.concavity, kClearConcavity + convex, kClearConcavity));
        }
        continues_[i] = continues;
        starts_[i] = starts;
    }
}

void LinePartFinder::fadeAtHairpins(const LineCourse& line, double reach) {
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
        const float turned = rise(product / std::sqrt(squares), kHairpinCosine, 0);
        continues_[i] = std::min(continues_[i], turned);
    }
    if (line.closed) continues_[points_] = continues_[0];
}

/// Along the line from where it starts, less and less, and never more than goes on.
void LinePartFinder::spread(const LineCourse& line, double reach) {
    seen_.assign(line.count, 0);
    const auto pass = [&](std::size_t i, std::size_t before, float& carried) {
        const double step = std::abs(sums_[offset_ + i].length - sums_[offset_ + before].length);
        const float faded = carried - float(step / reach);
        carried = std::max(std::min(starts_[i], continues_[i]), std::min(faded, continues_[i]));
        seen_[i] = std::max(seen_[i], std::min(continues_[i], 2 * carried));
    };
    const int rounds = line.closed ? 2 : 1;
    float carried = 0;
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < line.count; ++i)
            pass(i, i > 0 ? i - 1 : 0, carried);
    carried = 0;
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = line.count; i-- > 0;)
            pass(i, i + 1 < line.count ? i + 1 : i, carried);
}

void LinePartFinder::collectParts(const LineCourse& line) {
    parts_.clear();
    const auto unseen = std::find_if(seen_.begin(), seen_.end(), [](float v) { return !(v > 0); });
    if (line.closed && unseen == seen_.end()) {
        parts_.push_back({0, line.count, true});
        return;
    }
    // a closed line is followed from where it is not seen, once around
    const std::size_t first = line.closed ? std::size_t(unseen - seen_.begin()) : 0;
    for (std::size_t i = first; i < first + points_; ++i) {
        const std::size_t begin = i;
        while (i < first + points_ && seen_[i % points_] > 0)
            ++i;
        if (i > begin + 1) parts_.push_back({begin, i - begin, false});
    }
}

}  // namespace laplacian_lines
