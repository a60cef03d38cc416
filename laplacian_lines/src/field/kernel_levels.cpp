// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_lines/kernel_levels.h"

#include <algorithm>
#include <cmath>

#include "laplacian_lines/precompute_options.h"

namespace laplacian_lines {
namespace {

constexpr double kLargestStep = 1.4143;  // lines of a larger one change place too far
constexpr double kBand = 0.5;            // share of a step in which there are two levels

}  // namespace

KernelLevels::KernelLevels(double mean_edge, double diagonal) {
    const KernelRange range = drawn_kernel_range(mean_edge, diagonal);
    const double ratio = range.most / range.least;
    if (!(range.least > 0) || !std::isfinite(ratio)) return;
    least_ = range.least;
    steps_ = int(std::ceil(std::log(ratio) / std::log(kLargestStep)));
    if (steps_ > 0) step_ = std::pow(ratio, 1. / steps_);
}

double KernelLevels::size(int level) const {
    return least_ * std::pow(step_, level);
}

std::vector<LevelShare> KernelLevels::at(double wanted) const {
    if (steps_ == 0 || !(wanted > least_)) return {{0, 1}};
    const double place = std::min(std::log(wanted / least_) / std::log(step_), double(steps_));
    const int below = int(place), above = below + 1;
    const double passed = (place - below - 0.5) / kBand + 0.5;
    if (passed <= 0) return {{below, 1}};
    if (passed >= 1) return {{above, 1}};
    if (passed < 0.5) return {{below, 1}, {above, 2 * passed}};
    return {{above, 1}, {below, 2 - 2 * passed}};
}

}  // namespace laplacian_lines
