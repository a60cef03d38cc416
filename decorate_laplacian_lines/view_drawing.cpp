// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_drawing.h"

#include <QTimer>
#include <algorithm>

#include "printed_scene.h"

using line_renderer::DepthTexture;
using line_renderer::LinePlacement;
using line_renderer::RedrawClock;
using line_renderer::SurfaceDepth;
using line_renderer::SurfaceLayer;
using line_renderer::SurfaceStyle;

bool ViewLayers::are_in_depth_buffer(const Redraw& redraw) {
    return std::all_of(redraw.layers.begin(), redraw.layers.end(),
                       [](const auto& layer) { return layer.second.layer.is_in_depth_buffer; });
}

bool ViewLayers::are_in_depth_buffer(View view) const {
    const auto redraw = views_.find(view);
    return redraw != views_.end() && are_in_depth_buffer(redraw->second);
}

/// Removes layers that the redraw did not reach. Returns whether there were any.
bool ViewLayers::drop_missing(Redraw& redraw) {
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
    if (!is_first && !is_expected) redraw.has_mismatch = true;
    entry = {layer, true};
    if (!end_is_due_) QTimer::singleShot(0, &receiver_, [this] { end_redraws(); });
    end_is_due_ = true;
    return is_expected;
}

void ViewLayers::keep_only(View view, const std::vector<int>& shown) {
    auto& layers = views_[view].layers;
    for (auto layer = layers.begin(); layer != layers.end();)
        layer = std::binary_search(shown.begin(), shown.end(), layer->first) ? std::next(layer)
                                                                             : layers.erase(layer);
}

void ViewLayers::begin(Redraw& redraw) {
    drop_missing(redraw);
    for (auto& layer : redraw.layers)
        layer.second.is_drawn = false;
    redraw.is_over = redraw.has_mismatch = false;
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

void ViewLayers::end_redraws() {
    end_is_due_ = false;
    for (auto& view : views_) {
        Redraw& redraw = view.second;
        if (redraw.is_over) continue;
        redraw.is_over = true;
        const bool matters = !are_in_depth_buffer(redraw);
        const bool was_wrong = drop_missing(redraw) || redraw.has_mismatch;
        if (was_wrong && matters && redraw.widget) redraw.widget->update();
    }
}

void ViewDrawing::draw(const LayerInView& layer, const laplacian_lines::LineSet& lines,
                       const DecorationParameters& chosen, RedrawClock& clock) {
    LinePlacement placement = layer.placement;
    placement.depths = prepare(layer, !lines.lines.empty(), chosen);
    clock.count(RedrawClock::DrawCalls);
    lines_.upload(lines, chosen.appearance, placement);
    clock.count(RedrawClock::Upload);
    lines_.draw(chosen.appearance, placement, clock);
    clock.count(RedrawClock::DrawCalls);
}

void ViewDrawing::draw(const LayerInView& layer, const line_renderer::InkPicture& lines,
                       const Eigen::Vector2i& corner, const DecorationParameters& chosen) {
    prepare(layer, false, chosen);
    if (!layer.is_first) return;
    std::vector<QColor> colors;
    for (const ColoredInk& ink : inks_of(chosen))
        colors.push_back(ink.color);
    pictures_.paint(lines, colors, corner);
}

void ViewDrawing::forget(ViewLayers::View view) {
    layers_.forget(view);
}

DepthTexture ViewDrawing::prepare(const LayerInView& layer, bool has_lines,
                                  const DecorationParameters& chosen) {
    if (layer.is_first) {
        layers_.keep_only(layer.view, layer.shown);
        depth_.forget_depth_buffer();
        if (chosen.surface != SurfaceLook::AsMeshLabDrawsIt) surfaces_.paint_background();
    }
    const bool is_expected =
        layers_.note(layer.view, layer.widget, layer.mesh, layer.surface, layer.is_first);
    DepthTexture known;
    if (layer.is_first || !is_expected || has_lines) known = depths(layer.view);
    if (layer.is_first)
        paint(layers_.of(layer.view), chosen.surface, layer.modelview, known);
    else if (!is_expected)
        paint({layer.surface}, chosen.surface, layer.modelview, known);
    return known;
}

DepthTexture ViewDrawing::depths(ViewLayers::View view) {
    if (layers_.are_in_depth_buffer(view) && SurfaceDepth::can_copy()) return depth_.copy();
    return depth_.update(layers_.of(view), buffers_);
}

void ViewDrawing::paint(const std::vector<SurfaceLayer>& layers, SurfaceLook look,
                        const Eigen::Matrix4d& modelview, const DepthTexture& depths) {
    if (look != SurfaceLook::Paper && look != SurfaceLook::Toon) return;
    const SurfaceStyle style =
        look == SurfaceLook::Paper ? SurfaceStyle::Paper : SurfaceStyle::Toon;
    for (const SurfaceLayer& layer : layers)
        surfaces_.paint(layer, style, modelview * layer.transform, depths, buffers_);
}
