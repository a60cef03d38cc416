// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fixed/zero_lines.h"

namespace laplacian_lines {

/// Which parts of lines are shown: those with the least gradient, and their continuations down to
/// half of it.
struct StrongLineRules {
    float least;                       ///< gradient
    float fading;                      ///< opacity is 1 at (1 + fading) times half of `least`
    float least_length, least_strong;  ///< of a stretch and of its strong part, D
    float clearance;                   ///< points nearer to a contour fade; D, in the picture
    int smoothing_passes;
};

/// Most weight of sharp pieces in the length of a strong part: noise on a smooth surface is short
/// and blunt, the spine of a dragon short and sharp.
constexpr float kMostSharpness = 3;

/// Lines of which a style shows the strong parts.
class StrongLines {
public:
    explicit StrongLines(ZeroLines found);

    const ZeroLines& all() const { return found_; }

    /// Appends what the rules show. `left_out`: by point, if not null.
    void append(const ExtractorData& data, const LocalEye& eye, const StrongLineRules& rules,
                const std::vector<std::uint8_t>* left_out, LineSet& lines) const;

private:
    /// Of a line's points.
    struct Largest {
        float gradient = 0;
        float triangle = 0, piece = 0;  // D
    };

    const ZeroLines found_;
    std::vector<Largest> largest_;  // by line
};

}  // namespace laplacian_lines
