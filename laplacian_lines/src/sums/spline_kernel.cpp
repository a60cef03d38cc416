// SPDX-License-Identifier: GPL-3.0-or-later
#include "sums/spline_kernel.h"

#include <algorithm>
#include <cmath>

namespace laplacian_lines {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kFrequencies = 512;
constexpr int kAliases = 4;
constexpr double kLeastRoughness = 0.01;  // a plane: Δn is next to nothing

/// Fourier transform.
double spline_transform(double w, int degree) {
    return std::pow(std::sin(w / 2) / (w / 2), degree + 1);
}

double influence(double w, double sigma) {
    double spread_aliases = 0, value_aliases = 0;
    for (int m = -kAliases; m <= kAliases; ++m) {
        spread_aliases += std::pow(spline_transform(w + 2 * kPi * m, 3), 2);
        value_aliases += std::pow(spline_transform(w + 2 * kPi * m, 4), 2);
    }
    const double gaussian = sigma * std::sqrt(2 * kPi) * std::exp(-sigma * sigma * w * w / 2);
    return gaussian * spline_transform(w, 3) * spline_transform(w, 4) /
           (spread_aliases * value_aliases);
}

}  // namespace

std::vector<double> spline_kernel(double sigma, int count) {
    std::vector<double> taps(std::size_t(count), 0);
    for (int f = 0; f < kFrequencies; ++f) {
        const double w = kPi * (f + 0.5) / kFrequencies;
        const double value = influence(w, sigma) / kFrequencies;
        for (int j = 0; j < count; ++j)
            taps[std::size_t(j)] += value * std::cos((j + 0.5) * w);
    }
    return taps;
}

GridResolution grid_resolution(double accuracy, double roughness) {
    const double turn = std::clamp(roughness, kLeastRoughness, 1.0);
    GridResolution resolution;
    // The largest error on the test meshes is 1.1e-3 cell^4.9 / turn down to 0.7 √h and falls more
    // slowly below; tests/core/reference_test.cpp holds it to the accuracy.
    resolution.cell = std::min(1.25, std::pow(accuracy * turn / 1.4e-3, 1 / 4.7));
    // Beyond it lies less than a quarter of the accuracy of the second moment along an axis.
    resolution.cutoff = 6.3 - 0.85 * std::log10(accuracy / 1e-3);
    resolution.band_nodes = accuracy < 2e-4 ? 6 : 4;
    // The terms of Δn are turn² of the summed masses; those carry a rounding error of 3e-7.
    resolution.doubles = accuracy * turn * turn < 5e-6;
    return resolution;
}

}  // namespace laplacian_lines
