// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "decoration_parameters.h"
#include "laplacian_lines/line_set.h"
#include "line_renderer/line_renderer.h"
#include "line_renderer/picture_renderer.h"
#include "line_renderer/surface_depth.h"
#include "line_renderer/surface_renderer.h"
#include "view_layers.h"

/// A layer that a redraw of a view has reached.
struct LayerInView {
    ViewLayers::View view = nullptr;
    QWidget* widget = nullptr;  ///< shows the view, or null
    int mesh = 0;               ///< its id in the document
    bool is_first = true;       ///< of the redraw
    std::vector<int> shown;     ///< if it is the first: ids of all layers in sight, ascending
    Eigen::Matrix4d modelview;  ///< of the camera: world to eye coordinates
    line_renderer::SurfaceLayer surface;
    line_renderer::LinePlacement placement;  ///< without depths
};

/// Draws, in each redraw, the background, then all layers' surfaces, then the lines layer by layer,
/// since they reach beyond their own outline. A layer that is not as in the redraw before comes
/// late, over lines of others; the view is then drawn again. Needs the view's context current with
/// the camera's matrices; keeps OpenGL's state. GUI thread only.
class ViewDrawing {
public:
    /// @throws std::runtime_error if OpenGL cannot do it
    void draw(const LayerInView& layer, const laplacian_lines::LineSet& lines,
              const DecorationParameters& chosen, line_renderer::RedrawClock& clock);
    /// The same if the lines of all layers are a picture, in the inks of inks_of(). `corner`: the
    /// picture's pixel at the view's upper left.
    /// @throws std::runtime_error if OpenGL cannot do it
    void draw(const LayerInView& layer, const line_renderer::InkPicture& lines,
              const Eigen::Vector2i& corner, const DecorationParameters& chosen);
    /// The view is gone.
    void forget(ViewLayers::View view);

private:
    /// Draws background and surfaces. If there are lines, returns the depths of what hides them.
    line_renderer::DepthTexture prepare(const LayerInView& layer, bool has_lines,
                                        const DecorationParameters& chosen);
    line_renderer::DepthTexture depths(ViewLayers::View view);
    void paint(const std::vector<line_renderer::SurfaceLayer>& layers, SurfaceLook look,
               const Eigen::Matrix4d& modelview, const line_renderer::DepthTexture& known);

    ViewLayers layers_;
    line_renderer::SurfaceBuffers buffers_;
    line_renderer::SurfaceDepth depth_;
    line_renderer::SurfaceRenderer surfaces_;
    line_renderer::LineRenderer lines_;
    line_renderer::PictureRenderer pictures_;
};
