// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/chain_labels.h"

#include <algorithm>
#include <limits>

namespace laplacian_lines {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

struct Labelling {
    std::vector<std::uint8_t> labels;
    double cost = kNever;
};

double change_cost(const LabelCosts& piece, int from, int to) {
    return from == to ? 0 : piece.change[std::size_t(from)];
}

/// A. Viterbi, "Error Bounds for Convolutional Codes and an Asymptotically Optimum Decoding
/// Algorithm", 1967. `first` is the first piece's label of a closed chain, -1 if it is free.
Labelling cheapest(const std::vector<LabelCosts>& pieces, int first) {
    const std::size_t n = pieces.size();
    std::vector<std::array<std::uint8_t, 2>> from(n);
    std::array<double, 2> cost = pieces[0].label;
    if (first >= 0) cost[std::size_t(1 - first)] = kNever;
    for (std::size_t i = 1; i < n; ++i) {
        std::array<double, 2> next;
        for (int to = 0; to < 2; ++to) {
            const double of_0 = cost[0] + change_cost(pieces[i], 0, to);
            const double of_1 = cost[1] + change_cost(pieces[i], 1, to);
            from[i][std::size_t(to)] = of_1 < of_0;
            next[std::size_t(to)] = std::min(of_0, of_1) + pieces[i].label[std::size_t(to)];
        }
        cost = next;
    }
    if (first >= 0)
        for (int last = 0; last < 2; ++last)
            cost[std::size_t(last)] += change_cost(pieces[0], last, first);
    Labelling result{std::vector<std::uint8_t>(n), std::min(cost[0], cost[1])};
    result.labels[n - 1] = cost[1] < cost[0];
    for (std::size_t i = n; i-- > 1;)
        result.labels[i - 1] = from[i][result.labels[i]];
    return result;
}

}  // namespace

std::vector<std::uint8_t> cheapest_labels(const std::vector<LabelCosts>& pieces, bool closed) {
    if (pieces.empty()) return {};
    if (!closed) return cheapest(pieces, -1).labels;
    Labelling without = cheapest(pieces, 0), with = cheapest(pieces, 1);
    return with.cost < without.cost ? with.labels : without.labels;
}

}  // namespace laplacian_lines
