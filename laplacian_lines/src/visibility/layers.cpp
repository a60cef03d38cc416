// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/layers.h"

#include <algorithm>

namespace laplacian_lines {
namespace {

LayerStep step_of(const Passage& passage) {
    return {passage.may_show ? -1 : 1, passage.may_hide ? 1 : -1};
}

bool undoes(const Passage& a, const Passage& b) {
    return a.may_hide == b.may_show && a.may_show == b.may_hide;
}

}  // namespace

std::vector<LayerStep> steps_of(const LineSet& lines, const Polyline& line,
                                const std::vector<Passage>& passages, double sure) {
    std::vector<bool> is_sure;
    for (const Passage& passage : passages)
        is_sure.push_back(passage.distance > sure);
    const auto is_short_way = [&](std::size_t a, std::size_t b) {
        const auto place = [&](std::size_t i) {
            return point_at(lines, line, passages[i].place).position;
        };
        return double((place(b) - place(a)).norm()) < sure;
    };
    std::vector<std::size_t> open;  // sure ones that have not been undone
    for (std::size_t i = 0; i < passages.size(); ++i) {
        if (!is_sure[i]) continue;
        if (open.empty() || !undoes(passages[open.back()], passages[i]) ||
            !is_short_way(open.back(), i)) {
            open.push_back(i);
            continue;
        }
        is_sure[i] = is_sure[open.back()] = false;
        open.pop_back();
    }
    std::vector<LayerStep> steps;
    for (std::size_t i = 0; i < passages.size(); ++i) {
        const LayerStep step = step_of(passages[i]);
        steps.push_back(is_sure[i] ? step
                                   : LayerStep{std::min(0, step.least), std::max(0, step.most)});
    }
    return steps;
}

LayerCosts layer_costs(double length, double seen, const LayerStep& step,
                       const LayerPrices& prices) {
    constexpr int last = int(kLayerLabels) - 1;
    LayerCosts costs;
    costs.label.fill(seen * length);
    costs.label[0] = (1 - seen) * length;
    for (int from = 0; from <= last; ++from)
        for (int to = 0; to <= last; ++to) {
            // the last label stands for more layers, too, of which some may be left
            const int least = std::min(from + step.least, last);
            const int most = from == last ? last : from + step.most;
            const int wrong = std::max({0, least - to, to - most});
            const bool is_change = (from == 0) != (to == 0);
            costs.change[std::size_t(from)][std::size_t(to)] =
                wrong * prices.layer + is_change * prices.sight;
        }
    return costs;
}

}  // namespace laplacian_lines
