// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// Where a part of a whole line turns back sharply. Keeps its memory for the next line.
class Hairpins {
public:
    /// Returns whether there is any; none is found near ends, nor where a closed line begins.
    /// `kernel_size`: √h, in the unit of the points.
    bool find(const LinePoint* line, std::uint32_t count, float kernel_size);

    /// How much of the line goes on at each point: 0 at a hairpin, 1 away from any.
    const std::vector<float>& passes() const { return passes_; }

    /// Beyond a hairpin a line is its own companion on the convex side, which is drawn only as far
    /// as it is clear by itself, or carried by what is: opacities fade towards hairpins and beyond.
    /// `clear`: how clear the line is by itself, by point; overwritten.
    void fade(std::vector<float>& clear, LinePoint* line) const;

private:
    std::vector<float> lengths_;  // from the first point to each
    std::vector<float> passes_;
};

}  // namespace laplacian_lines
