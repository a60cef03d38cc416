// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace laplacian_lines {

/// The filter that goes from nodes, onto which cubic B-splines have spread masses, to values half a
/// cell further on, from which quartic B-splines interpolate Σ m exp(−x²/2σ²). σ in cells.
/// Symmetric: tap j, 0 <= j < count, is for nodes at the distance j + 1/2.
std::vector<double> spline_kernel(double sigma, int count);

}  // namespace laplacian_lines
