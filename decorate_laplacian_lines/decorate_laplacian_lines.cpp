// SPDX-License-Identifier: GPL-3.0-or-later
#include "decorate_laplacian_lines.h"

#include <QPainter>
#include <stdexcept>

#include "decoration_parameters.h"
#include "meshlab_host/layer_drawing.h"
#include "meshlab_host/live_meshes.h"
#include "meshlab_host/log.h"
#include "redraw_mark.h"

using line_renderer::DepthTexture;
using line_renderer::LinePlacement;
using line_renderer::RedrawClock;
using line_renderer::SurfaceAppearance;
using line_renderer::SurfaceDepth;
using line_renderer::SurfaceLayer;

namespace {

const QString title = "Laplacian Lines";

meshlab_host::DecorationDescription description() {
    return {"DecorateLaplacianLines", title,
            "Draws Laplacian lines: the zero crossings of the illumination's Laplacian, with the "
            "light at the eye, and the occluding contours. Run the filter Compute Laplacian Lines "
            "first to choose how they are computed; otherwise the default parameters are used."};
}

/// Eye and light in mesh coordinates.
laplacian_lines::View viewOf(const meshlab_host::CameraMatrices& camera,
                             const Eigen::Matrix4d& layer, const DecorationParameters& chosen) {
    auto view = meshlab_host::viewFromMatrices(camera.modelview, camera.projection, layer);
    if (!view) throw std::runtime_error("The layer's transformation cannot be inverted.");
    if (chosen.light == Light::FixedToTheCamera)
        view->light = meshlab_host::directionInMesh(meshlab_host::towardsLight(chosen.camera_light),
                                                    camera.modelview, layer);
    return *view;
}

QString statistics(const laplacian_lines::LineSet& lines, const RedrawClock& clock,
                   double switching_on) {
    const auto spent = [&](const char* name, RedrawClock::Part part) {
        return QString("%1 %2 ms").arg(name).arg(clock.milliseconds(part), 0, 'f', 2);
    };
    return QString("%1 lines, %2 segments; %3, %4, %5, %6; switched on in %7 s")
        .arg(lines.lines.size())
        .arg(lines.segment_count())
        .arg(spent("extraction", RedrawClock::Extraction), spent("upload", RedrawClock::Upload),
             spent("draw calls", RedrawClock::DrawCalls),
             spent("drawing by OpenGL", RedrawClock::Drawing))
        .arg(1e-3 * switching_on, 0, 'f', 3);
}

/// The widget that is being painted, null if it is none.
QWidget* widgetOf(QPainter* painter) {
    return painter ? dynamic_cast<QWidget*>(painter->device()) : nullptr;
}

QString refusalLine(const MeshModel& mesh, const QString& refusal) {
    return QString("%1: %2: %3").arg(title, mesh.label(), refusal);
}

double devicePixelRatio(QPainter* painter) {
    return painter && painter->device() ? painter->device()->devicePixelRatioF() : 1;
}

}  // namespace

DecorateLaplacianLines::DecorateLaplacianLines() : DecoratePluginBase(description()) {}

void DecorateLaplacianLines::listParameters(RichParameterList& list) const {
    listDecorationParameters(list);
}

bool DecorateLaplacianLines::start(MeshModel& mesh, const RichParameterList&, GLArea* view) {
    QString refusal;
    try {
        refusal = demandLines(mesh, view)->failure;
    } catch (const std::exception& error) {
        refusal = QString::fromUtf8(error.what());
    }
    if (refusal.isEmpty()) return true;
    complain(mesh, meshlab_host::documentLog(mesh), refusal);
    return false;
}

void DecorateLaplacianLines::draw(MeshModel& mesh, const RichParameterList& parameters,
                                  GLArea* view, QPainter* painter, GLLogStream& log) {
    emit drawingBegins(mesh);
    QString text, refusal;
    if (shows_statistics_) glFinish();  // the mesh's own drawing must not count
    RedrawClock clock;
    try {
        PreparedLinesPointer lines = cache_.at(view, mesh.id());
        if (!lines || !areCurrent(*lines, mesh, view, painter)) lines = demandLines(mesh, view);
        refusal = lines->failure;
        if (refusal.isEmpty()) text = drawLines(mesh, *lines, parameters, view, painter, clock);
    } catch (const std::exception& error) {
        refusal = QString::fromUtf8(error.what());
    }
    if (refusal.isEmpty())
        complaints_.erase({&log, mesh.id()});
    else if (!isSaid(mesh, log, refusal))
        complain(mesh, &log, refusal);
    const QString& message = refusal.isEmpty() ? text : refusal;
    if (!message.isEmpty()) meshlab_host::writeOnView(log, title, mesh.label(), message);
    emit drawingEnds(mesh, parameters, refusal.isEmpty() ? &lines_ : nullptr, refusal);
}

void DecorateLaplacianLines::end(MeshModel& mesh, GLArea* view) {
    cache_.release(view, mesh.id());
}

void DecorateLaplacianLines::endAll(GLArea* view) {
    cache_.releaseView(view);
    view_layers_.forget(view);
    complaints_.clear();  // another document may get the place of a closed one
}

void DecorateLaplacianLines::meshGone(GLArea* view) {
    cache_.releaseUnlessAssigned(view);
}

PreparedLinesPointer DecorateLaplacianLines::demandLines(MeshModel& mesh, GLArea* view) {
    const std::vector<int> alive = meshlab_host::liveMeshIds(mesh);
    if (!alive.empty()) cache_.releaseAllBut(view, alive);
    const meshlab_host::FieldSource source = meshlab_host::fieldSource(mesh.cm);
    PreparedLinesPointer lines = cache_.find(source.key);
    if (!lines || lines->lacked_memory)
        lines = prepareLines(mesh.cm, mesh.label(), source, [this](const QString& s) { say(s); });
    cache_.assign(view, mesh.id(), lines);
    return lines;
}

bool DecorateLaplacianLines::areCurrent(const PreparedLines& lines, const MeshModel& mesh,
                                        GLArea* view, QPainter* painter) {
    if (!meshlab_host::sameCounts(lines.key.stamp, mesh.cm)) return false;
    const Eigen::Matrix4d modelview = meshlab_host::cameraFromGl().modelview;
    return !cache_.isCheckDue(view, mesh.id(), modelview, widgetOf(painter)) ||
           meshlab_host::geometryStamp(mesh.cm) == lines.key.stamp;
}

QString DecorateLaplacianLines::drawLines(const MeshModel& mesh, const PreparedLines& lines,
                                          const RichParameterList& parameters, GLArea* view,
                                          QPainter* painter, RedrawClock& clock) {
    const DecorationParameters chosen = readDecorationParameters(parameters);
    shows_statistics_ = chosen.show_statistics;
    const meshlab_host::CameraMatrices camera = meshlab_host::cameraFromGl();
    const Eigen::Matrix4d layer = meshlab_host::layerTransform(mesh.cm);
    const laplacian_lines::View eye = viewOf(camera, layer, chosen);

    clock.count(RedrawClock::DrawCalls);
    lines.extractor->extract(eye, chosen.style, scratch_, lines_);
    clock.count(RedrawClock::Extraction);

    const meshlab_host::LayerDrawing shown = meshlab_host::layerDrawing(mesh);
    const SurfaceLayer surface = {lines.surface, layer, lines.diagonal, shown.culls_back_faces,
                                  shown.has_faces && shown.mark_pixels == 0};
    LinePlacement placement;
    placement.to_eye = camera.modelview * layer;
    placement.projection = camera.projection;
    placement.diagonal = lines.diagonal;
    placement.mean_edge = lines.mean_edge;
    placement.pixel_scale = devicePixelRatio(painter) * tiles_.scale(camera);
    placement.mark_pixels = shown.mark_pixels;
    const bool is_first = beginsRedraw(painter);
    if (is_first) beginRedraw(chosen);
    const bool is_expected =
        view_layers_.note(view, widgetOf(painter), mesh.id(), surface, is_first);
    if (is_first || !is_expected || !lines_.lines.empty()) placement.depths = depths(view);
    if (is_first)
        paint(view_layers_.of(view), chosen.surface, camera, placement.depths);
    else if (!is_expected)
        paint({surface}, chosen.surface, camera, placement.depths);
    clock.count(RedrawClock::DrawCalls);
    renderer_.upload(lines_, chosen.appearance, placement);
    clock.count(RedrawClock::Upload);
    renderer_.draw(chosen.appearance, placement, clock);
    clock.count(RedrawClock::DrawCalls);
    if (!lines.first_redraw) lines.first_redraw = clock.ownMilliseconds();
    if (!chosen.show_statistics) return {};
    glFinish();
    clock.count(RedrawClock::Drawing);
    return statistics(lines_, clock, lines.preparation + *lines.first_redraw);
}

void DecorateLaplacianLines::beginRedraw(const DecorationParameters& chosen) {
    surface_depth_.forgetDepthBuffer();
    if (chosen.background == Background::Paper) background_renderer_.paint(chosen.surface.paper);
}

DepthTexture DecorateLaplacianLines::depths(GLArea* view) {
    if (view_layers_.areInDepthBuffer(view) && SurfaceDepth::canCopy())
        return surface_depth_.copy();
    return surface_depth_.update(view_layers_.of(view), buffers_);
}

void DecorateLaplacianLines::paint(const std::vector<SurfaceLayer>& layers,
                                   const SurfaceAppearance& appearance,
                                   const meshlab_host::CameraMatrices& camera,
                                   const DepthTexture& depths) {
    if (appearance.style == SurfaceAppearance::AsMeshLabDrawsIt) return;
    for (const SurfaceLayer& layer : layers)
        surface_renderer_.paint(layer, appearance, camera.modelview * layer.transform, depths,
                                buffers_);
}

bool DecorateLaplacianLines::isSaid(const MeshModel& mesh, const GLLogStream& log,
                                    const QString& refusal) const {
    const auto last = complaints_.find({&log, mesh.id()});
    if (last == complaints_.end() || last->second.refusal != refusal) return false;
    return !last->second.is_kept || meshlab_host::hasLine(log, refusalLine(mesh, refusal));
}

void DecorateLaplacianLines::complain(const MeshModel& mesh, const GLLogStream* log,
                                      const QString& refusal) {
    const QString line = refusalLine(mesh, refusal);
    say(line);
    complaints_[{log, mesh.id()}] = {refusal, log && meshlab_host::hasLine(*log, line)};
}

MESHLAB_PLUGIN_NAME_EXPORTER(DecorateLaplacianLines)
