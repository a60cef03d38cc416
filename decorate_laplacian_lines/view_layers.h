// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>
#include <map>
#include <vector>

#include "line_renderer/surface.h"

/// The surfaces of all layers that a view shows with lines. MeshLab draws layer after layer, but
/// each may hide lines of any other, also of those drawn before it. So a redraw takes the layers
/// that it has not reached yet as they were in the redraw before, and once it is over, the view is
/// drawn again if that was wrong. GUI thread only.
class ViewLayers {
public:
    using View = const void*;  ///< a key, never dereferenced

    /// To be called for each layer that a redraw of the view reaches, `mesh` its id; `widget` shows
    /// the view and may be null. `is_painted`: surfaces are, so one that comes late covers lines.
    /// Returns whether the layer is as it was in the redraw before.
    bool reach(View view, QWidget* widget, int mesh, const line_renderer::SurfaceLayer& layer,
               bool is_first, bool is_painted);
    /// Forgets layers of the view that are gone or hidden: those not in `shown`, ascending ids.
    void forget_all_but(View view, const std::vector<int>& shown);
    /// The view is gone.
    void forget(View view);

    /// The view's layers, by id: those reached are as they are now, others as they were before.
    std::vector<line_renderer::SurfaceLayer> in(View view) const;
    /// Whether MeshLab's depth buffer has the faces of all these layers, and nothing else of them.
    bool are_in_depth_buffer(View view) const;

private:
    struct Entry {
        line_renderer::SurfaceLayer layer;
        bool is_reached = false;  ///< by the current redraw
    };
    struct Redraw {
        std::map<int, Entry> layers;  ///< by mesh
        QPointer<QWidget> widget;
        bool is_over = true;
        bool is_painted = false;
        bool was_wrong = false;  ///< a layer had changed after lines were drawn
    };

    static bool are_in_depth_buffer(const Redraw& redraw);
    static bool drop_unreached(Redraw& redraw);

    void end_redraws();

    std::map<View, Redraw> views_;
    bool end_is_due_ = false;
    QObject receiver_;  ///< of the end of redraws; destroyed first
};
