// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_layers.h"

#include <QTimer>
#include <algorithm>

/// Whether the depth buffer alone cannot say what hides lines.
bool ViewLayers::needsTexture(const Redraw& redraw) {
    return std::any_of(redraw.layers.begin(), redraw.layers.end(),
                       [](const auto& layer) { return !layer.second.layer.is_in_depth_buffer; });
}

/// Removes the layers to which the redraw has not come. Returns whether there were any.
bool ViewLayers::dropMissing(Redraw& redraw) {
    const std::size_t before = redraw.layers.size();
    for (auto layer = redraw.layers.begin(); layer != redraw.layers.end();)
        layer = layer->second.is_drawn ? std::next(layer) : redraw.layers.erase(layer);
    return redraw.layers.size() < before;
}

void ViewLayers::note(View view, QWidget* widget, int mesh, const SurfaceLayer& layer,
                      bool is_first) {
    Redraw& redraw = views_[view];
    redraw.widget = widget;
    if (is_first) begin(redraw);
    const auto [place, is_new] = redraw.layers.try_emplace(mesh);
    Entry& entry = place->second;
    if (!is_first && (is_new || entry.layer != layer)) redraw.has_surprised = true;
    entry = {layer, true};
    if (end_is_due_) return;
    end_is_due_ = true;
    QTimer::singleShot(0, &receiver_, [this] { endRedraws(); });
}

void ViewLayers::begin(Redraw& redraw) {
    dropMissing(redraw);
    for (auto& layer : redraw.layers)
        layer.second.is_drawn = false;
    redraw.is_over = redraw.has_surprised = false;
}

const std::vector<SurfaceLayer>& ViewLayers::besideDepthBuffer(View view) {
    listed_.clear();
    const Redraw& redraw = views_[view];
    if (!needsTexture(redraw)) return listed_;
    for (const auto& layer : redraw.layers)
        listed_.push_back(layer.second.layer);
    return listed_;
}

void ViewLayers::forget(View view) {
    views_.erase(view);
}

void ViewLayers::endRedraws() {
    end_is_due_ = false;
    for (auto& view : views_) {
        Redraw& redraw = view.second;
        if (redraw.is_over) continue;
        redraw.is_over = true;
        const bool matters = needsTexture(redraw);
        const bool was_wrong = dropMissing(redraw) || redraw.has_surprised;
        if (was_wrong && matters && redraw.widget) redraw.widget->update();
    }
}
