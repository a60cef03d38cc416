// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "laplacian_lines/field.h"

namespace laplacian_lines {

/// √h of C and S̄, mesh units: fits need more vertices than the Laplacian's sums do.
inline double derivative_kernel(const FieldScale& scale) {
    return std::max(scale.kernel_size, 2 * scale.mean_edge);
}

/// h_e = h + σ²/2 of a whole mesh, in D², for a √h in mesh units.
inline double squared_scale(double kernel_size, const FieldScale& scale) {
    const double size = kernel_size / scale.diagonal, sigma = scale.normal_sigma / scale.diagonal;
    return size * size + sigma * sigma / 2;
}

}  // namespace laplacian_lines
