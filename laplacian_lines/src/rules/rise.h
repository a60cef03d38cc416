// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace laplacian_lines {

/// 0 at `from`, 1 from `to` on; a step there if they are equal.
inline float rise(float v, float from, float to) {
    if (v >= to) return 1;
    return v > from ? (v - from) / (to - from) : 0;
}

}  // namespace laplacian_lines
