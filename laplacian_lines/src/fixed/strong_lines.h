// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fixed/zero_lines.h"

namespace laplacian_lines {

/// Which places of lines are strong, by their gradient; weaker ones, down to half of it, are shown
/// where they continue these.
struct StrongLineRules {
    float least;                       ///< gradient
    float fading;                      ///< from nothing at the weakest to full opacity
    float least_length, least_strong;  ///< of a stretch and of its strong part, D
    float clearance;                   ///< nearer to a contour points fade; D, in the picture
    int smoothing_passes;
};

/// Of strong parts sharper pieces count more: what noise makes of a smooth surface is short and
/// dull, the spine of a dragon is short and sharp. Up to so many times.
constexpr float kMostSharpness = 3;

/// Lines of which a style shows what is strong.
class StrongLines {
public:
    explicit StrongLines(ZeroLines found);

    const LineSet& lines() const { return found_.lines; }

    /// Appends what the rules show. `left_out`: by point, if not null.
    void append(const ExtractorData& data, const LocalEye& eye, const StrongLineRules& rules,
                const std::vector<std::uint8_t>* left_out, LineSet& lines) const;

private:
    const ZeroLines found_;
    std::vector<float> strongest_;  // the largest gradient of a line's points, by line
};

}  // namespace laplacian_lines
