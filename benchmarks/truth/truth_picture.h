// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "truth_scores.h"

namespace benchmarks {

/// A drawing and where it is mistaken, 10 pixels a mm, as PNG: exact lines light gray (tangent
/// edges lighter), drawn ones thin and black; missed exact ones red, wrong ones blue, doubled ones
/// green, loose ends in orange rings.
/// @throws std::runtime_error
void write_truth_picture(const QString& file, const DrawnPaths& drawing, const ExactLines& exact,
                         const TruthDetails& details);

}  // namespace benchmarks
