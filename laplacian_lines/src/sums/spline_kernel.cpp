// SPDX-License-Identifier: GPL-3.0-or-later
// Spreading by a spline of degree 3 multiplies the spectrum of the masses by that spline's
// transform U₃(w), and the nodes repeat it at all w + 2πm, its aliases; interpolation multiplies by
// U₄ at every alias. The filter K has to make up for both. The one whose error is least, on average
// over all places of the nodes, is the optimal influence function of R. W. Hockney and J. W.
// Eastwood, "Computer Simulation Using Particles", section 8-3, along one axis:
//     K(w) = G(w) U₃(w) U₄(w) / (Σ_m U₃(w + 2πm)² · Σ_m U₄(w + 2πm)²),
// with the Gaussian's transform G, whose own aliases vanish. Taps are its inverse transform.
#include "sums/spline_kernel.h"

#include <Eigen/Core>
#include <cmath>

namespace laplacian_lines {
namespace {

constexpr double kPi = EIGEN_PI;
constexpr int kFrequencies = 512;  // at which K is sampled: taps reach less than that
constexpr int kAliases = 4;        // to either side: others are below 1e-7 of the sums

/// Fourier transform of the B-spline of a degree.
double spline_transform(double w, int degree) {
    return std::pow(std::sin(w / 2) / (w / 2), degree + 1);
}

/// K(w), w in radians a cell.
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

}  // namespace laplacian_lines
