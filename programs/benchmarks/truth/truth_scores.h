// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "flat_drawing.h"

namespace benchmarks {

/// Counts and lengths, mm; add up over drawings.
struct TruthScores {
    double demanded = 0, found = 0;  ///< of the exact lines; of them, what is drawn
    double drawn = 0, right = 0;     ///< of the drawing; of it, what is near an exact line
    double squares = 0;              ///< of the distances of what is right, times its length
    double doubled = 0;              ///< of the drawing, what runs along another path
    int ends = 0, loose_ends = 0;    ///< of open paths; those at no other path and no true end
    int outlines = 0, closed_outlines = 0;

    double recall() const { return demanded > 0 ? found / demanded : 1; }
    double precision() const { return drawn > 0 ? right / drawn : 1; }
    double rms() const { return right > 0 ? std::sqrt(squares / right) : 0; }
    double worst() const { return std::min(recall(), precision()); }
    void add(const TruthScores& other);
};

enum class Mistake { Missed, Wrong, Doubled };
struct MistakenPart {
    Mistake mistake;
    PlaneLine points;
};

struct TruthDetails {
    std::vector<MistakenPart> parts;
    PlaneLines::value_type loose_ends;
    double longest_missed = 0, longest_wrong = 0;  ///< in one piece, mm
};

struct ExactLines {
    const PlaneLines& demanded;
    const PlaneLines& allowed;
};

/// Lines may be `tolerance` mm off, and `slack` mm more at true ends, for coarse meshes. Adds to
/// `details`, if any.
TruthScores score(const DrawnPaths& drawing, const ExactLines& exact, double tolerance,
                  double slack = 0, TruthDetails* details = nullptr);

}  // namespace benchmarks
