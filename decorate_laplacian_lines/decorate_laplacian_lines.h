// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "laplacian_lines/line_extractor.h"
#include "line_cache.h"
#include "line_renderer/background_renderer.h"
#include "line_renderer/line_renderer.h"
#include "line_renderer/redraw_clock.h"
#include "line_renderer/surface_depth.h"
#include "line_renderer/surface_renderer.h"
#include "meshlab_host/camera.h"
#include "meshlab_host/decorate_plugin_base.h"
#include "meshlab_host/snapshot_tiles.h"
#include "view_layers.h"

struct DecorationParameters;

/// MeshLab's side of drawing: mesh attributes, camera and parameters in, lines on the screen out.
/// Never draws lines of a geometry that the mesh does not have any more.
class DecorateLaplacianLines : public meshlab_host::DecoratePluginBase {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESHLAB_HOST_DECORATE_IID)
    Q_INTERFACES(MESHLAB_HOST_DECORATE_INTERFACE)

public:
    DecorateLaplacianLines();

signals:
    /// For observers, around each drawing of a layer and with MeshLab's GL context current, which
    /// they must leave as it is. `lines` in mesh coordinates, valid during the call; null if none
    /// could be drawn, for the reason in `refusal`.
    void drawingBegins(const MeshModel& mesh);
    void drawingEnds(const MeshModel& mesh, const RichParameterList& parameters,
                     const laplacian_lines::LineSet* lines, const QString& refusal);

protected:
    void listParameters(RichParameterList& list) const override;
    bool start(MeshModel& mesh, const RichParameterList& parameters, GLArea* view) override;
    void draw(MeshModel& mesh, const RichParameterList& parameters, GLArea* view, QPainter* painter,
              GLLogStream& log) override;
    void end(MeshModel& mesh, GLArea* view) override;
    void endAll(GLArea* view) override;
    void meshGone(GLArea* view) override;

private:
    /// Lines of the mesh's present geometry, found or prepared, and assigned to the view.
    PreparedLinesPointer demandLines(MeshModel& mesh, GLArea* view);
    /// Whether lines still belong to the mesh, as far as this is looked at while the camera moves.
    bool areCurrent(const PreparedLines& lines, const MeshModel& mesh, GLArea* view,
                    QPainter* painter);
    /// Text for the view, empty if there is nothing to tell. Throws what is to be complained about.
    QString drawLines(const MeshModel& mesh, const PreparedLines& lines,
                      const RichParameterList& parameters, GLArea* view, QPainter* painter,
                      line_renderer::RedrawClock& clock);
    /// What comes before all layers of a view.
    void beginRedraw(const DecorationParameters& chosen);
    /// Of all that hides lines in the view.
    line_renderer::DepthTexture depths(GLArea* view);
    /// Paints the surfaces, if that is wanted. Those of all layers come before any line, which
    /// reaches over the outline of its own.
    void paint(const std::vector<line_renderer::SurfaceLayer>& layers,
               const line_renderer::SurfaceAppearance& appearance,
               const meshlab_host::CameraMatrices& camera,
               const line_renderer::DepthTexture& depths);
    /// Adds why a mesh has no lines to its document's log, which is `log`.
    void complain(const MeshModel& mesh, const GLLogStream* log, const QString& refusal);
    /// Whether the log's reader knows it: said before, and not taken out of the log since.
    bool isSaid(const MeshModel& mesh, const GLLogStream& log, const QString& refusal) const;

    LineCache cache_;
    ViewLayers view_layers_;
    meshlab_host::SnapshotTiles tiles_;
    line_renderer::SurfaceBuffers buffers_;
    line_renderer::SurfaceDepth surface_depth_;
    line_renderer::BackgroundRenderer background_renderer_;
    line_renderer::LineRenderer renderer_;
    line_renderer::SurfaceRenderer surface_renderer_;
    laplacian_lines::ExtractionScratch scratch_;
    laplacian_lines::LineSet lines_;
    bool shows_statistics_ = false;
    struct Complaint {
        QString refusal;
        bool is_kept = false;  ///< by the log; some hosts show a line and forget it
    };
    /// What has been said, by a document's log and mesh, since its lines were last drawn: once, not
    /// at every redraw.
    std::map<std::pair<const GLLogStream*, int>, Complaint> complaints_;
};
