// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_drawing.h"

#include <optional>

#include "printed_scene.h"

using line_renderer::DepthTexture;
using line_renderer::LinePlacement;
using line_renderer::RedrawClock;
using line_renderer::SurfaceDepth;
using line_renderer::SurfaceLayer;
using line_renderer::SurfaceStyle;

namespace {

/// None if surfaces stay as MeshLab draws them.
std::optional<SurfaceStyle> style_of(SurfaceLook look) {
    if (look == SurfaceLook::Paper) return SurfaceStyle::Paper;
    if (look == SurfaceLook::Toon) return SurfaceStyle::Toon;
    return std::nullopt;
}

}  // namespace

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
        layers_.forget_all_but(layer.view, layer.shown);
        depth_.forget_depth_buffer();
        if (chosen.surface != SurfaceLook::AsMeshLabDrawsIt) surfaces_.paint_background();
    }
    const bool is_expected = layers_.reach(layer.view, layer.widget, layer.mesh, layer.surface,
                                           layer.is_first, style_of(chosen.surface).has_value());
    DepthTexture known;
    const bool paints = style_of(chosen.surface) && (layer.is_first || !is_expected);
    if (paints || has_lines) known = depths(layer.view);
    if (layer.is_first)
        paint(layers_.in(layer.view), chosen.surface, layer.modelview, known);
    else if (!is_expected)
        paint({layer.surface}, chosen.surface, layer.modelview, known);
    return known;
}

DepthTexture ViewDrawing::depths(ViewLayers::View view) {
    if (layers_.are_in_depth_buffer(view) && SurfaceDepth::can_copy()) return depth_.copy();
    return depth_.update(layers_.in(view), buffers_);
}

void ViewDrawing::paint(const std::vector<SurfaceLayer>& layers, SurfaceLook look,
                        const Eigen::Matrix4d& modelview, const DepthTexture& known) {
    const std::optional<SurfaceStyle> style = style_of(look);
    if (!style) return;
    for (const SurfaceLayer& layer : layers)
        surfaces_.paint(layer, *style, modelview * layer.transform, known, buffers_);
}
