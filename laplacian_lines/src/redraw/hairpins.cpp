// SPDX-License-Identifier: GPL-3.0-or-later
// At a point of a line, the cosine between the ways to it and from it, each over kReach, tells how
// sharply the line turns: from a right angle on less of it goes on, from 110° on nothing.
#include "redraw/hairpins.h"

#include <algorithm>
#include <cmath>

#include "rules/thresholds.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr float kReach = 0.375f;            // to both sides, in √h
constexpr float kSharpestCosine = -0.342f;  // of 110°

/// Cosine between the ways from a to b and from b to c, if it is negative; else 1.
float cosine_of_turn(const LinePoint& a, const LinePoint& b, const LinePoint& c) {
    const Eigen::Vector3f u = b.position - a.position, v = c.position - b.position;
    const float product = dot(u, v);
    if (product >= 0) return 1;
    return product / std::sqrt(squared_length_of(u) * squared_length_of(v));
}

}  // namespace

bool Hairpins::find(const LinePoint* line, std::uint32_t count, float kernel_size) {
    lengths_.assign(count, 0.f);
    passes_.assign(count, 1.f);
    for (std::size_t i = 1; i < count; ++i)
        lengths_[i] = lengths_[i - 1] + length_of(line[i].position - line[i - 1].position);
    const float reach = kReach * kernel_size;
    bool any = false;
    std::size_t low = 0, high = 0;
    for (std::size_t i = 0; i < count && high < count; ++i) {
        while (low < i && lengths_[low + 1] <= lengths_[i] - reach)
            ++low;
        while (high < count && lengths_[high] < lengths_[i] + reach)
            ++high;
        if (lengths_[low] > lengths_[i] - reach || high == count) continue;
        passes_[i] = rise(cosine_of_turn(line[low], line[i], line[high]), kSharpestCosine, 0);
        any |= passes_[i] < 1;
    }
    return any;
}

void Hairpins::fade(std::vector<float>& clear, LinePoint* line) const {
    float carried = 0, most = 0;
    for (std::size_t i = 0; i < passes_.size(); ++i)
        clear[i] = carried = std::max(clear[i] * passes_[i], std::min(carried, passes_[i]));
    carried = 0;
    for (std::size_t i = passes_.size(); i-- > 0; most = std::max(most, carried))
        clear[i] = carried = std::max(clear[i], std::min(carried, passes_[i]));
    for (std::size_t i = 0; i < passes_.size(); ++i)
        // in full from half of what is clearest on
        line[i].opacity *= std::min(passes_[i], most > 0 ? 2 * clear[i] / most : 1.f);
}

}  // namespace laplacian_lines
