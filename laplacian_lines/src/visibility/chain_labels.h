// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace laplacian_lines {

/// What it costs to give a piece of a chain each of `Count` labels, and to change from one label
/// ([from]) to another ([from][to]) before the piece. Before the first one of an open chain nothing
/// changes.
template <std::size_t Count>
struct LabelCosts {
    std::array<double, Count> label{};
    std::array<std::array<double, Count>, Count> change{};
};

/// The labels of least cost in all; of equal ones the least. A closed chain's last piece is before
/// its first one. There are instances for 2 labels and for kLayerLabels.
template <std::size_t Count>
std::vector<std::uint8_t> cheapest_labels(const std::vector<LabelCosts<Count>>& pieces,
                                          bool closed);

/// Labels that are numbers of layers which hide a piece; the last one stands for more, too.
constexpr std::size_t kLayerLabels = 4;

}  // namespace laplacian_lines
