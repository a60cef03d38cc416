// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "item_buffer.h"

namespace benchmarks {

/// Counts of places between pixels, that add up over drawings.
struct SilhouetteScores {
    std::size_t border = 0;       ///< between surface and background
    std::size_t bare_border = 0;  ///< of it, without a line within .15 mm
    std::size_t far_border = 0;   ///< of it, without a line within .8 mm
    std::size_t jumps = 0;        ///< of depth, by more than .5 mm
    std::size_t bare_jumps = 0;

    /// Of the border, what has a line within .8 mm.
    double share() const { return border ? 1 - double(far_border) / double(border) : 1; }
    void add(const SilhouetteScores& other);
};

/// Those that have no line within .15 mm.
struct BarePlaces {
    PlaneLine border, jumps;
};

SilhouetteScores score_silhouette(const ItemBuffer& items, const DrawnPaths& drawing,
                                  BarePlaces* bare = nullptr);

}  // namespace benchmarks
