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

template <std::size_t Count>
std::size_t least_of(const std::array<double, Count>& costs) {
    return std::size_t(std::min_element(costs.begin(), costs.end()) - costs.begin());
}

/// A. Viterbi, "Error Bounds for Convolutional Codes and an Asymptotically Optimum Decoding
/// Algorithm", 1967. `first` is the first piece's label of a closed chain, `Count` if it is free.
template <std::size_t Count>
Labelling cheapest(const std::vector<LabelCosts<Count>>& pieces, std::size_t first) {
    const std::size_t n = pieces.size();
    std::vector<std::array<std::uint8_t, Count>> from(n);
    std::array<double, Count> cost = pieces[0].label;
    for (std::size_t label = 0; first < Count && label < Count; ++label)
        if (label != first) cost[label] = kNever;
    for (std::size_t i = 1; i < n; ++i) {
        std::array<double, Count> next;
        for (std::size_t to = 0; to < Count; ++to) {
            std::array<double, Count> costs;
            for (std::size_t label = 0; label < Count; ++label)
                costs[label] = cost[label] + pieces[i].change[label][to];
            const std::size_t best = least_of(costs);
            from[i][to] = std::uint8_t(best);
            next[to] = costs[best] + pieces[i].label[to];
        }
        cost = next;
    }
    for (std::size_t last = 0; first < Count && last < Count; ++last)
        cost[last] += pieces[0].change[last][first];
    const std::size_t best = least_of(cost);
    Labelling result{std::vector<std::uint8_t>(n), cost[best]};
    result.labels[n - 1] = std::uint8_t(best);
    for (std::size_t i = n; i-- > 1;)
        result.labels[i - 1] = from[i][result.labels[i]];
    return result;
}

}  // namespace

template <std::size_t Count>
std::vector<std::uint8_t> cheapest_labels(const std::vector<LabelCosts<Count>>& pieces,
                                          bool closed) {
    if (pieces.empty()) return {};
    if (!closed) return cheapest(pieces, Count).labels;
    Labelling best;
    for (std::size_t first = 0; first < Count; ++first) {
        Labelling other = cheapest(pieces, first);
        if (other.cost < best.cost) best = std::move(other);
    }
    return best.labels;
}

template std::vector<std::uint8_t> cheapest_labels(const std::vector<LabelCosts<2>>&, bool);
template std::vector<std::uint8_t> cheapest_labels(const std::vector<LabelCosts<kLayerLabels>>&,
                                                   bool);

}  // namespace laplacian_lines
