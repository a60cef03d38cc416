// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plane_lines.h"

namespace benchmarks {

/// Of one drawing; lengths in mm.
struct TruthScores {
    double recall = 1;         ///< the share of the exact lines that is drawn
    double precision = 1;      ///< the share of the drawing that is near an exact line
    int ends = 0;              ///< of open paths
    PlaneLines missed, wrong;  ///< in small pieces
    PlaneLine loose_ends;      ///< at no other path and no true end
};

/// Lines may be `tolerance` mm off, and `slack` mm more at true ends, for coarse meshes. Those that
/// are `allowed` need not be drawn.
TruthScores score(const PlaneLines& drawing, const PlaneLines& demanded, const PlaneLines& allowed,
                  double tolerance, double slack = 0);

}  // namespace benchmarks
