// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "visibility/chain_labels.h"
#include "visibility/picture_crossings.h"

namespace laplacian_lines {

/// By how much the number of layers before a line may change at a place of it (A. Appel, "The
/// Notion of Quantitative Invisibility and the Machine Rendering of Solids", 1967).
struct LayerStep {
    int least = 0, most = 0;

    LayerStep& operator+=(const LayerStep& other) {
        least += other.least;
        most += other.most;
        return *this;
    }

    bool may_be_none() const { return least <= 0 && most >= 0; }
};

/// At each passage of a line: a layer more on the side that the outline covers. An outline that is
/// nearer to the line than `sure`, or that is passed to and fro within that length, may lie a
/// little beside its place: then nothing has to change.
std::vector<LayerStep> steps_of(const LineSet& lines, const Polyline& line,
                                const std::vector<Passage>& passages, double sure);

/// What it costs that the number of layers changes otherwise than it may, a layer; and that sight
/// changes. In lengths of wrong votes.
struct LayerPrices {
    double layer, sight;
};

using LayerCosts = LabelCosts<kLayerLabels>;

/// Of a piece of this length, of which this share of rays reaches the eye, with a step before it.
LayerCosts layer_costs(double length, double seen, const LayerStep& step,
                       const LayerPrices& prices);

}  // namespace laplacian_lines
