// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>
#include <map>
#include <vector>

#include "line_renderer/surface.h"

/// The layers whose lines a view shows. MeshLab redraws them one by one, while each can hide lines
/// of any: later ones are taken from the last redraw, and if they have changed, the view is drawn
/// again. GUI thread only.
class ViewLayers {
public:
    using View = const void*;  ///< a name, never followed

    /// The redraw of a view, shown by `widget` or null, has come to a mesh, the first if
    /// `is_first`. Whether it is as expected.
    bool note(View view, QWidget* widget, int mesh, const line_renderer::SurfaceLayer& layer,
              bool is_first);
    /// Only these layers, ascending, are still there and shown.
    void keepOnly(View view, const std::vector<int>& shown);
    /// As far as they are known. Valid until the next call.
    const std::vector<line_renderer::SurfaceLayer>& of(View view);
    /// Whether the depth buffer has the faces of all layers, and nothing else of them.
    bool areInDepthBuffer(View view) const;
    void forget(View view);

private:
    struct Entry {
        line_renderer::SurfaceLayer layer;
        bool is_drawn = false;  ///< this redraw has come to it
    };
    struct Redraw {
        std::map<int, Entry> layers;  ///< by mesh
        QPointer<QWidget> widget;
        bool is_over = true;
        bool has_surprised = false;  ///< a layer was other than expected, after lines were drawn
    };

    static bool areInDepthBuffer(const Redraw& redraw);
    static bool dropMissing(Redraw& redraw);
    static void begin(Redraw& redraw);

    void endRedraws();

    std::map<View, Redraw> views_;
    std::vector<line_renderer::SurfaceLayer> listed_;
    bool end_is_due_ = false;
    QObject receiver_;  ///< of the end of redraws; destroyed first
};
