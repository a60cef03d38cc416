// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/line_rules.h"

#include <cmath>

#include "laplacian_lines/line_style.h"

namespace laplacian_lines {
double threshold_factor(double detail) {
    // Fitted to the number of lines on the Stanford bunny and dragon, igea and the armadillo.
    const double x = detail / 50 - 1;  // -1..1
    return std::exp2(x < 0 ? 3.5 * std::pow(-x, 1.6) : -5 * std::pow(x, 1.3));
}

int smoothing_passes(double deviation) {
    return int(std::lround(2 * deviation * deviation));  // a pass has a variance of 1/2
}

}  // namespace laplacian_lines
