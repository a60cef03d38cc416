// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "decoration_parameters.h"
#include "laplacian_lines/line_set.h"
#include "line_renderer/background_renderer.h"
#include "line_renderer/line_renderer.h"
#include "line_renderer/surface_depth.h"
#include "line_renderer/surface_renderer.h"
#include "view_layers.h"

/// A layer to which the redraw of a view has come.
struct LayerInView {
    ViewLayers::View view = nullptr;
    QWidget* widget = nullptr;  ///< shows the view, or null
    int mesh = 0;
    bool is_first = true;       ///< of the redraw
    Eigen::Matrix4d modelview;  ///< of the camera: world to eye coordinates
    line_renderer::SurfaceLayer surface;
    line_renderer::LinePlacement placement;  ///< without depths
};

/// Draws the lines of layers into views, and what comes before them: in each redraw first the
/// background, then the surfaces of all layers, then the lines of one layer after the other, which
/// reach over the outline of their own. Needs the view's context to be current, with the camera's
/// matrices, and leaves OpenGL's state as it was. GUI thread only.
class ViewDrawing {
public:
    /// @throws std::runtime_error if OpenGL cannot do it
    void draw(const LayerInView& layer, const laplacian_lines::LineSet& lines,
              const DecorationParameters& chosen, line_renderer::RedrawClock& clock);
    /// The view is gone.
    void forget(ViewLayers::View view);

private:
    /// What comes before the layer's lines. Returns the depths of all that hides them, if there are
    /// any lines.
    line_renderer::DepthTexture prepare(const LayerInView& layer, bool has_lines,
                                        const DecorationParameters& chosen);
    line_renderer::DepthTexture depths(ViewLayers::View view);
    void paint(const std::vector<line_renderer::SurfaceLayer>& layers,
               const line_renderer::SurfaceAppearance& appearance, const Eigen::Matrix4d& modelview,
               const line_renderer::DepthTexture& depths);

    ViewLayers layers_;
    line_renderer::SurfaceBuffers buffers_;
    line_renderer::SurfaceDepth depth_;
    line_renderer::BackgroundRenderer background_;
    line_renderer::SurfaceRenderer surfaces_;
    line_renderer::LineRenderer lines_;
};
