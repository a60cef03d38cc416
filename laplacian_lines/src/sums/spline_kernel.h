// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace laplacian_lines {

struct GridResolution {
    double cell = 0;       ///< in √h
    double cutoff = 0;     ///< of the convolution along each axis, in √h
    int band_nodes = 4;    ///< kernel sizes between which the sums of others are interpolated
    bool doubles = false;  ///< floats are too coarse
};

/// The coarsest grid that gives Δn to a relative accuracy, 1e-6..0.1. `roughness`: RMS of √h|S|,
/// the turn of the normals within a kernel: all but about this part of the terms of Δn cancel on a
/// smooth surface.
GridResolution grid_resolution(double accuracy, double roughness);

/// At 0 <= t < 1 from the second of four nodes. T: numbers or vectors.
template <class T>
inline __attribute__((always_inline)) void cubic_spline(T t, T weights[4]) {
    const T s = 1. - t;
    weights[0] = s * s * s * (1 / 6.);
    weights[1] = (t * t * (3. * t - 6.) + 4.) * (1 / 6.);
    weights[2] = (s * s * (3. * s - 6.) + 4.) * (1 / 6.);
    weights[3] = t * t * t * (1 / 6.);
}

/// Quartic B-splines and their derivatives at the same point, on five nodes half way between those
/// of the cubic ones, the first half a cell before theirs; by the recursions of C. de Boor, "A
/// Practical Guide to Splines", chapters IX and X.
template <class T>
inline __attribute__((always_inline)) void quartic_spline(T t, const T cubic[4], T weights[5],
                                                          T derivatives[5]) {
    for (int k = 0; k < 5; ++k) {
        const T x = t - (k - 1.5);  // from node k
        const T left = k > 0 ? cubic[k - 1] : T{}, right = k < 4 ? cubic[k] : T{};
        weights[k] = ((2.5 + x) * left + (2.5 - x) * right) * 0.25;
        derivatives[k] = left - right;
    }
}

/// The filter from masses spread by cubic B-splines to values half a cell further on from which
/// quartic B-splines interpolate Σ m exp(−x²/2σ²); σ in cells. Symmetric: tap j, 0 <= j < count, is
/// for nodes at the distance j + 1/2. The optimal influence function of Hockney and Eastwood,
/// section 8-3, along one axis.
std::vector<double> spline_kernel(double sigma, int count);

}  // namespace laplacian_lines
