// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_layers.h"

#include <QTimer>
#include <algorithm>

using line_renderer::SurfaceLayer;

bool ViewLayers::reach(View view, QWidget* widget, int mesh, const SurfaceLayer& layer,
                       bool is_first, bool is_painted) {
    Redraw& redraw = views_[view];
    redraw.widget = widget;
    redraw.is_painted = is_painted;
    if (is_first) {
        drop_unreached(redraw);
        for (auto& entry : redraw.layers)
            entry.second.is_reached = false;
        redraw.is_over = redraw.was_wrong = false;
    }
    const auto [place, is_new] = redraw.layers.try_emplace(mesh);
    const bool is_expected = !is_new && place->second.layer == layer;
    if (!is_first && !is_expected) redraw.was_wrong = true;
    place->second = {layer, true};
    if (!end_is_due_) QTimer::singleShot(0, &receiver_, [this] { end_redraws(); });
    end_is_due_ = true;
    return is_expected;
}

void ViewLayers::forget_all_but(View view, const std::vector<int>& shown) {
    auto& layers = views_[view].layers;
    for (auto layer = layers.begin(); layer != layers.end();)
        layer = std::binary_search(shown.begin(), shown.end(), layer->first) ? std::next(layer)
                                                                             : layers.erase(layer);
}

void ViewLayers::forget(View view) {
    views_.erase(view);
}

std::vector<SurfaceLayer> ViewLayers::in(View view) const {
    std::vector<SurfaceLayer> layers;
    if (const auto redraw = views_.find(view); redraw != views_.end())
        for (const auto& entry : redraw->second.layers)
            layers.push_back(entry.second.layer);
    return layers;
}

bool ViewLayers::are_in_depth_buffer(View view) const {
    const auto redraw = views_.find(view);
    return redraw != views_.end() && are_in_depth_buffer(redraw->second);
}

bool ViewLayers::are_in_depth_buffer(const Redraw& redraw) {
    return std::all_of(redraw.layers.begin(), redraw.layers.end(),
                       [](const auto& entry) { return entry.second.layer.is_in_depth_buffer; });
}

/// Returns whether there were any.
bool ViewLayers::drop_unreached(Redraw& redraw) {
    const std::size_t before = redraw.layers.size();
    for (auto layer = redraw.layers.begin(); layer != redraw.layers.end();)
        layer = layer->second.is_reached ? std::next(layer) : redraw.layers.erase(layer);
    return redraw.layers.size() < before;
}

/// Control has returned to the event loop, so every redraw has reached all its layers.
void ViewLayers::end_redraws() {
    end_is_due_ = false;
    for (auto& view : views_) {
        Redraw& redraw = view.second;
        if (redraw.is_over) continue;
        redraw.is_over = true;
        // by the depth buffer, layers hide each other whichever of them are known
        const bool matters = redraw.is_painted || !are_in_depth_buffer(redraw);
        const bool was_wrong = drop_unreached(redraw) || redraw.was_wrong;
        if (was_wrong && matters && redraw.widget) redraw.widget->update();
    }
}
