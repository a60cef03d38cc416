// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>

#include "decoration_parameters.h"
#include "laplacian_lines/line_extractor.h"
#include "line_cache.h"
#include "line_renderer/redraw_clock.h"
#include "meshlab_host/camera.h"
#include "meshlab_host/decorate_plugin_base.h"
#include "meshlab_host/snapshot_dialog.h"
#include "printed_views.h"
#include "view_drawing.h"

/// Draws the lines of a mesh from its attributes, the camera and the parameters; prepares them anew
/// once GeometryCheck finds that the mesh has changed.
class DecorateLaplacianLines : public meshlab_host::DecoratePluginBase {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESHLAB_HOST_DECORATE_IID)
    Q_INTERFACES(MESHLAB_HOST_DECORATE_INTERFACE)

public:
    DecorateLaplacianLines();

protected:
    void list_parameters(RichParameterList& list) const override;
    bool start(MeshModel& mesh, const RichParameterList& parameters, GLArea* view) override;
    void draw(MeshModel& mesh, const RichParameterList& parameters, GLArea* view, QPainter* painter,
              GLLogStream& log) override;
    void end(MeshModel& mesh, GLArea* view) override;
    void end_all(GLArea* view) override;
    void mesh_gone(GLArea* view) override;

private:
    /// Values out of range stay as they were last time.
    ValidParameters valid_parameters(const RichParameterList& parameters);
    /// Lines of the mesh's present geometry, from the cache or prepared now; the view's from now
    /// on.
    PreparedLinesPointer find_or_prepare_lines(MeshModel& mesh, GLArea* view,
                                               bool needs_derivatives);
    /// The view's lines if they still belong to the mesh, as far as that is checked while the
    /// camera moves; else null.
    PreparedLinesPointer current_lines(const MeshModel& mesh, GLArea* view, QPainter* painter);
    /// Keeps lines in the cache while the mesh and its document live and memory allows.
    void keep(const MeshModel& mesh, const PreparedLinesPointer& lines);

    /// Draws the layer's lines, or the printed drawing of all layers. Returns text for the view, if
    /// any. @throws std::exception with the reason why lines cannot be drawn
    QString draw_lines(const MeshModel& mesh, PreparedLines& lines,
                       const DecorationParameters& chosen, GLArea* view, QPainter* painter,
                       line_renderer::RedrawClock& clock);
    QString draw_live_lines(PreparedLines& lines, const laplacian_lines::View& eye,
                            const LayerInView& layer, const DecorationParameters& chosen,
                            line_renderer::RedrawClock& clock);
    /// To be called once a redraw for each layer, since it marks the redraw. `tiles`, here and
    /// below: in a row of the picture of which this redraw draws one.
    LayerInView layer_in_view(const MeshModel& mesh, const PreparedLines& lines,
                              const meshlab_host::CameraMatrices& camera, int tiles, GLArea* view,
                              QPainter* painter) const;

    /// The printed drawing, if it is ready, else an empty one. Logs why there cannot be one.
    Print request_print(const MeshModel& mesh, const DecorationParameters& chosen,
                        const LayerInView& layer, int tiles);
    /// The view as it would be printed, if that is wanted and possible.
    std::optional<PrintedView> printed_view(const MeshModel& mesh,
                                            const DecorationParameters& chosen,
                                            const LayerInView& layer, int tiles) const;
    /// All visible layers of the mesh's document; null if one has no lines, or they are too large.
    std::shared_ptr<PrintedScene> printed_scene(const MeshModel& mesh, ViewLayers::View view) const;

    /// Logs why a mesh or a parameter is refused, unless that was its last message as well; empty:
    /// nothing is. `log` is its document's.
    void log_refusal(const MeshModel& mesh, const GLLogStream* log, const QString& refusal);
    /// Logs once, for each layer that was added after the lines of others, why it has none.
    void log_new_layers(const MeshModel& mesh, GLArea* view);

    DecorationParameters last_good_;
    LineCache cache_;
    KeptLines kept_;
    PrintedViews prints_;
    Print print_;  ///< of all layers, in the current redraw
    /// Ids of the layers that are not new, of the documents that are watched.
    std::map<const MeshDocument*, std::set<int>> known_layers_;
    /// The last refusal, by log, which is never dereferenced, and mesh.
    std::map<std::pair<const GLLogStream*, int>, QString> logged_refusals_;
    meshlab_host::SnapshotDialog snapshot_dialog_;
    meshlab_host::SnapshotTiles tiles_;
    ViewDrawing drawing_;
    laplacian_lines::ExtractionScratch scratch_;
    laplacian_lines::LineSet lines_;
    bool shows_statistics_ = false, has_looked_at_settings_ = false;
};
