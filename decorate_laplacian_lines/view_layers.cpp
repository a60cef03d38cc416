// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_layers.h"

#include <QTimer>
#include <algorithm>

using line_renderer::SurfaceLayer;

bool ViewLayers::areInDepthBuffer(const Redraw& redraw) {
    return std::all_of(redraw.layers.begin(), redraw.layers.end(),
                       [](const auto& layer) { return layer.second.layer.is_in_depth_buffer; });
}

bool ViewLayers::areInDepthBuffer(View view) const {
    const auto redraw = views_.find(view);
    return redraw != views_.end() && areInDepthBuffer(redraw->second);
}

/// Removes layers that the redraw did not reach. Whether there were any.
bool ViewLayers::dropMissing(Redraw& redraw) {
    const std::size_t before = redraw.layers.size();
    for (auto layer = redraw.layers.begin(); layer != redraw.layers.end();)
        layer = layer->second.is_drawn ? std::next(layer) : redraw.layers.erase(layer);
    return redraw.layers.size() < before;
}

bool ViewLayers::note(View view, QWidget* widget, int mesh, const SurfaceLayer& layer,
                      bool is_first) {
    Redraw& redraw = views_[view];
    redraw.widget = widget;
    if (is_first) begin(redraw);
    const auto [place, is_new] = redraw.layers.try_emplace(mesh);
    Entry& entry = place->second;
    const bool is_expected = !is_new && entry.layer == layer;
    if (!is_first && !is_expected) redraw.has_surprised = true;
    entry = {layer, true};
    if (!end_is_due_) QTimer::singleShot(0, &receiver_, [this] { endRedraws(); });
    end_is_due_ = true;
    return is_expected;
}

void ViewLayers::keepOnly(View view, const std::vector<int>& shown) {
    auto& layers = views_[view].layers;
    for (auto layer = layers.begin(); layer != layers.end();)
        layer = std::binary_search(shown.begin(), shown.end(), layer->first) ? std::next(layer)
                                                                             : layers.erase(layer);
}

void ViewLayers::begin(Redraw& redraw) {
    dropMissing(redraw);
    for (auto& layer : redraw.layers)
        layer.second.is_drawn = false;
    redraw.is_over = redraw.has_surprised = false;
}

const std::vector<SurfaceLayer>& ViewLayers::of(View view) {
    listed_.clear();
    for (const auto& layer : views_[view].layers)
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
        const bool matters = !areInDepthBuffer(redraw);
        const bool was_wrong = dropMissing(redraw) || redraw.has_surprised;
        if (was_wrong && matters && redraw.widget) redraw.widget->update();
    }
}
