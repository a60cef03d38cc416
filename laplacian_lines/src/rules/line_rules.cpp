// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/line_rules.h"

#include <cmath>

namespace laplacian_lines {
int smoothing_passes(double deviation) {
    return int(std::lround(2 * deviation * deviation));  // a pass has a variance of 1/2
}

}  // namespace laplacian_lines
