// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "part_file.h"
#include "truth_scores.h"

namespace benchmarks {

/// One mesh of a part from one direction.
struct ScoredDrawing {
    std::string part, view;
    DirectionClass direction_class = DirectionClass::Faces;
    double linear = 0, angular = 0;  ///< deflections of the mesh
    TruthScores scores;
    double longest_missed = 0, longest_wrong = 0;  ///< mm

    std::string name() const;
};
using ScoredDrawings = std::vector<ScoredDrawing>;

/// Recall and precision are averaged by drawing, the rest by length or number.
struct TruthMeans {
    explicit TruthMeans(const ScoredDrawings& drawings);

    std::size_t drawings = 0;
    double recall = 1, precision = 1;
    double least_recall = 1, least_precision = 1;
    TruthScores sum;
};

/// Markdown: a row per deflection and class of directions.
std::string truth_table(const ScoredDrawings& drawings);
/// Markdown: the drawings with the least recall or precision.
std::string worst_drawings(ScoredDrawings drawings, std::size_t count);

}  // namespace benchmarks
