// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace laplacian_lines {

/// What it costs to say of a piece of a chain that something does not hold (0) or holds (1), and to
/// change from not to yes ([0]) or back ([1]) before the piece. Before the first one of an open
/// chain nothing changes.
struct LabelCosts {
    std::array<double, 2> label{}, change{};
};

/// The labels of least cost in all; of equal ones those that hold least. A closed chain's last
/// piece is before its first one.
std::vector<std::uint8_t> cheapest_labels(const std::vector<LabelCosts>& pieces, bool closed);

}  // namespace laplacian_lines
