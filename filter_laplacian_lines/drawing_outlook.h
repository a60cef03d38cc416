// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "placed_layers.h"

/// What a drawing will be, in words, before it is made.
class DrawingOutlook {
public:
    /// Says what a unit is, how large the object is with it, and the scale and paper of the
    /// drawing, or why it cannot be made. Fields of the dialog by their labels. Layers are looked
    /// at anew only when they have changed. Nothing while a filter works on them.
    std::optional<QString> inWords(
        const MeshDocument& document,
        const std::function<std::optional<QString>(const QString& label)>& text_of);

private:
    void look(const MeshDocument& document, bool all_visible);

    std::vector<LayerState> seen_;
    PlacedLayers layers_;
};
