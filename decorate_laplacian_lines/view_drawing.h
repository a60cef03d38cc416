// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>
#include <map>
#include <vector>

#include "decoration_parameters.h"
#include "laplacian_lines/line_set.h"
#include "line_renderer/line_renderer.h"
#include "line_renderer/picture_renderer.h"
#include "line_renderer/surface_depth.h"
#include "line_renderer/surface_renderer.h"

/// The layers whose lines a view shows. MeshLab redraws them one by one, while each can hide lines
/// of any other: layers that follow are assumed to be as in the last redraw, and if they have
/// changed, the view is drawn again. GUI thread only.
class ViewLayers {
public:
    using View = const void*;  ///< a name, never followed

    /// The redraw of a view, shown by `widget` or null, reaches a mesh, the first if `is_first`.
    /// Returns whether the layer is as in the last redraw.
    bool note(View view, QWidget* widget, int mesh, const line_renderer::SurfaceLayer& layer,
              bool is_first);
    /// Only these layers, ascending, are still there and shown.
    void keep_only(View view, const std::vector<int>& shown);
    /// As far as they are known. Valid until the next call.
    const std::vector<line_renderer::SurfaceLayer>& of(View view);
    /// Whether the depth buffer has the faces of all layers, and nothing else of them.
    bool are_in_depth_buffer(View view) const;
    void forget(View view);

private:
    struct Entry {
        line_renderer::SurfaceLayer layer;
        bool is_drawn = false;  ///< this redraw has reached it
    };
    struct Redraw {
        std::map<int, Entry> layers;  ///< by mesh
        QPointer<QWidget> widget;
        bool is_over = true;
        bool has_mismatch = false;  ///< a layer had changed after lines were drawn
    };

    static bool are_in_depth_buffer(const Redraw& redraw);
    static bool drop_missing(Redraw& redraw);
    static void begin(Redraw& redraw);

    void end_redraws();

    std::map<View, Redraw> views_;
    std::vector<line_renderer::SurfaceLayer> listed_;
    bool end_is_due_ = false;
    QObject receiver_;  ///< of the end of redraws; destroyed first
};

/// A layer in a redraw of a view.
struct LayerInView {
    ViewLayers::View view = nullptr;
    QWidget* widget = nullptr;  ///< shows the view, or null
    int mesh = 0;
    bool is_first = true;       ///< of the redraw
    std::vector<int> shown;     ///< meshes of the document, ascending, if it is the first
    Eigen::Matrix4d modelview;  ///< of the camera: world to eye coordinates
    line_renderer::SurfaceLayer surface;
    line_renderer::LinePlacement placement;  ///< without depths
};

/// Draws, in each redraw, the background, then all layers' surfaces, then the lines layer by layer,
/// since they reach beyond their own outline. Needs the view's context current with the camera's
/// matrices; keeps OpenGL's state. GUI thread only.
class ViewDrawing {
public:
    /// @throws std::runtime_error if OpenGL cannot do it
    void draw(const LayerInView& layer, const laplacian_lines::LineSet& lines,
              const DecorationParameters& chosen, line_renderer::RedrawClock& clock);
    /// The same if the lines of all layers are a picture, in the inks of inks_of(), which the view
    /// shows from `corner` on.
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
               const Eigen::Matrix4d& modelview, const line_renderer::DepthTexture& depths);

    ViewLayers layers_;
    line_renderer::SurfaceBuffers buffers_;
    line_renderer::SurfaceDepth depth_;
    line_renderer::SurfaceRenderer surfaces_;
    line_renderer::LineRenderer lines_;
    line_renderer::PictureRenderer pictures_;
};
