// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/hairpins.h"

#include <algorithm>
#include <cmath>

#include "rules/opacity.h"

namespace laplacian_lines {
namespace {

constexpr float kReach = 0.375f;            // to both sides, in √h
constexpr float kSharpestCosine = -0.342f;  // of 110°

/// Cosine between the ways from a to b and from b to c; 1 where there is none.
float cosine_of_turn(const LineColumns& p, std::size_t a, std::size_t b, std::size_t c) {
    const float ux = p.x[b] - p.x[a], uy = p.y[b] - p.y[a], uz = p.z[b] - p.z[a];
    const float vx = p.x[c] - p.x[b], vy = p.y[c] - p.y[b], vz = p.z[c] - p.z[b];
    const float product = ux * vx + uy * vy + uz * vz;
    if (product >= 0) return 1;
    const float squares = (ux * ux + uy * uy + uz * uz) * (vx * vx + vy * vy + vz * vz);
    return product / std::sqrt(squares);
}

}  // namespace

void Hairpins::measure(const LineColumns& line) {
    for (std::size_t i = 1; i < lengths_.size(); ++i) {
        const float x = line.x[i] - line.x[i - 1], y = line.y[i] - line.y[i - 1],
                    z = line.z[i] - line.z[i - 1];
        lengths_[i] = std::sqrt(x * x + y * y + z * z);
    }
    for (std::size_t i = 1; i < lengths_.size(); ++i)
        lengths_[i] += lengths_[i - 1];
}

bool Hairpins::find(const LineColumns& line, std::uint32_t count, float kernel_size) {
    lengths_.assign(count, 0.f);
    passes_.assign(count, 1.f);
    measure(line);
    const float reach = kReach * kernel_size;
    bool any = false;
    std::size_t low = 0, high = 0;
    for (std::size_t i = 0; i < count && high < count; ++i) {
        while (low < i && lengths_[low + 1] <= lengths_[i] - reach)
            ++low;
        while (high < count && lengths_[high] < lengths_[i] + reach)
            ++high;
        if (lengths_[low] > lengths_[i] - reach || high == count) continue;
        passes_[i] = rise(cosine_of_turn(line, low, i, high), kSharpestCosine, 0);
        any |= passes_[i] < 1;
    }
    return any;
}

void Hairpins::split(const float* starts) {
    limbs_.clear();
    ranges_.clear();
    const auto count = std::uint32_t(passes_.size());
    limbs_.push_back({0, 0, 0, 0});
    std::uint32_t begin = 0;  // of what no hairpin cuts
    for (std::uint32_t i = 0; i < count; ++i) {
        limbs_.back().carried = std::max(limbs_.back().carried, starts[i] * passes_[i]);
        const bool turns = i > 0 && i + 1 < count && passes_[i] < 1 &&
                           passes_[i] <= passes_[i - 1] && passes_[i] < passes_[i + 1];
        if (turns) {
            limbs_.back().end = i;
            limbs_.push_back({i, i, passes_[i], 0});
        }
        if (passes_[i] > 0) continue;
        if (i > begin + 1) ranges_.push_back({begin, i});
        begin = i + 1;
    }
    limbs_.back().end = count;
    if (count > begin + 1) ranges_.push_back({begin, count});
}

/// From limb to limb, both ways; returns the most.
float Hairpins::carry() {
    for (std::size_t i = 1; i < limbs_.size(); ++i)
        limbs_[i].carried =
            std::max(limbs_[i].carried, std::min(limbs_[i].passes, limbs_[i - 1].carried));
    float most = 0;
    for (std::size_t i = limbs_.size(); i-- > 0; most = std::max(most, limbs_[i].carried))
        if (i + 1 < limbs_.size())
            limbs_[i].carried =
                std::max(limbs_[i].carried, std::min(limbs_[i + 1].passes, limbs_[i + 1].carried));
    return most;
}

void Hairpins::fade(const float* starts, float* opacities) {
    split(starts);
    const float most = carry();
    for (const Limb& limb : limbs_) {
        const float carried = most > 0 ? std::min(1.f, 2 * limb.carried / most) : 1.f;
        for (std::uint32_t i = limb.begin; i < limb.end; ++i)
            opacities[i] *= std::min(passes_[i], carried);
    }
}

}  // namespace laplacian_lines
