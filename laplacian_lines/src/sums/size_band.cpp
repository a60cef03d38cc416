// SPDX-License-Identifier: GPL-3.0-or-later
#include "sums/size_band.h"

#include <algorithm>
#include <cmath>

namespace laplacian_lines {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kWidestBand = 1.4142135623730951;  // ratio of its kernel sizes

}  // namespace

SizeBand::SizeBand(double smallest, double largest, int node_count)
    : smallest_(smallest), largest_(largest) {
    const double middle = std::sqrt(smallest * largest);
    const double half_width = std::log(largest / smallest) / 2;
    for (int j = node_count - 1; j >= 0; --j)
        nodes_.push_back(middle * std::exp(half_width * std::cos(kPi * (j + 0.5) / node_count)));
}

void SizeBand::weights(double size, double* weights) const {
    for (std::size_t j = 0; j < nodes_.size(); ++j) {
        const double ratio = size / nodes_[j];
        weights[j] = ratio * ratio * ratio * ratio;
        for (double other : nodes_)
            if (other != nodes_[j])
                weights[j] *= std::log(size / other) / std::log(nodes_[j] / other);
    }
}

std::vector<SizeBand> size_bands(const std::vector<float>& kernel_sizes, int node_count) {
    const auto range = std::minmax_element(kernel_sizes.begin(), kernel_sizes.end());
    const double smallest = *range.first, largest = *range.second;
    if (smallest == largest) return {SizeBand(smallest, largest, 1)};
    const double octaves = std::log(largest / smallest) / std::log(kWidestBand);
    const int count = std::max(1, int(std::ceil(octaves)));
    std::vector<SizeBand> bands;
    double low = smallest;
    for (int i = 1; i <= count; ++i) {
        const double high =
            i == count ? largest : smallest * std::pow(largest / smallest, double(i) / count);
        bands.emplace_back(low, high, node_count);
        low = std::nextafter(high, largest + high);
    }
    return bands;
}

}  // namespace laplacian_lines
