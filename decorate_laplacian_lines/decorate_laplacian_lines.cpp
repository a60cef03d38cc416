// SPDX-License-Identifier: GPL-3.0-or-later
#include "decorate_laplacian_lines.h"

#include <QElapsedTimer>
#include <QPainter>
#include <stdexcept>

#include "decoration_parameters.h"
#include "mean_scale.h"
#include "meshlab_host/live_meshes.h"
#include "meshlab_host/log.h"

namespace {

const QString title = "Laplacian Lines";

/// How far, in diagonals, a line may lie behind the surface and still be seen. Lines lie on the
/// triangles, but contours of the smoothed normals run a little beyond the visible horizon.
constexpr double depth_bias = 0.003;

meshlab_host::DecorationDescription description() {
    return {"DecorateLaplacianLines", title,
            "Draws Laplacian lines: the zero crossings of the illumination's Laplacian, with the "
            "light at the eye, and the occluding contours. Run the filter Compute Laplacian Lines "
            "first to choose how they are computed; otherwise the default parameters are used."};
}

double milliseconds(const QElapsedTimer& clock) {
    return 1e-6 * double(clock.nsecsElapsed());
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

QString statistics(const laplacian_lines::LineSet& lines, double extraction, double drawing) {
    return QString("%1 lines, %2 segments; extraction %3 ms, drawing %4 ms")
        .arg(lines.lines.size())
        .arg(lines.segment_count())
        .arg(extraction, 0, 'f', 2)
        .arg(drawing, 0, 'f', 2);
}

}  // namespace

DecorateLaplacianLines::DecorateLaplacianLines() : DecoratePluginBase(description()) {}

void DecorateLaplacianLines::listParameters(RichParameterList& list) const {
    listDecorationParameters(list);
}

bool DecorateLaplacianLines::start(MeshModel& mesh, const RichParameterList&, GLArea* view) {
    try {
        const PreparedLinesPointer lines = demandLines(mesh, view);
        if (lines->failure.isEmpty()) return true;
        say(QString("%1: %2: %3").arg(title, mesh.label(), lines->failure));
    } catch (const std::exception& error) {
        say(title + ": " + QString::fromUtf8(error.what()));
    }
    return false;
}

void DecorateLaplacianLines::draw(MeshModel& mesh, const RichParameterList& parameters,
                                  GLArea* view, QPainter* painter, GLLogStream& log) {
    QString text;
    try {
        PreparedLinesPointer lines = cache_.at(view, mesh.id());
        if (!lines || !areCurrent(*lines, mesh, view)) lines = demandLines(mesh, view);
        text = lines->failure.isEmpty() ? drawLines(mesh, *lines, parameters, painter)
                                        : lines->failure;
        complaints_.erase(mesh.id());
    } catch (const std::exception& error) {
        text = QString::fromUtf8(error.what());
        complain(mesh, text);
    }
    if (!text.isEmpty()) meshlab_host::writeOnView(log, title, mesh.label(), text);
}

void DecorateLaplacianLines::end(MeshModel& mesh, GLArea* view) {
    cache_.release(view, mesh.id());
}

void DecorateLaplacianLines::endAll(GLArea* view) {
    cache_.releaseView(view);
}

void DecorateLaplacianLines::meshGone(GLArea* view) {
    cache_.releaseUnlessAssigned(view);
}

PreparedLinesPointer DecorateLaplacianLines::demandLines(MeshModel& mesh, GLArea* view) {
    const std::vector<int> alive = meshlab_host::liveMeshIds(mesh);
    if (!alive.empty()) cache_.releaseAllBut(view, alive);
    const LineSource source = lineSource(mesh.cm);
    PreparedLinesPointer lines = cache_.find(source.key);
    if (!lines)
        lines = prepareLines(mesh.cm, mesh.label(), source, [this](const QString& s) { say(s); });
    cache_.assign(view, mesh.id(), lines);
    return lines;
}

bool DecorateLaplacianLines::areCurrent(const PreparedLines& lines, const MeshModel& mesh,
                                        GLArea* view) {
    if (!meshlab_host::sameCounts(lines.key.stamp, mesh.cm)) return false;
    return !cache_.isCheckDue(view, mesh.id()) ||
           meshlab_host::geometryStamp(mesh.cm) == lines.key.stamp;
}

QString DecorateLaplacianLines::drawLines(const MeshModel& mesh, const PreparedLines& lines,
                                          const RichParameterList& parameters, QPainter* painter) {
    DecorationParameters chosen = readDecorationParameters(parameters);
    if (painter && painter->device())
        chosen.appearance.width *= painter->device()->devicePixelRatioF();

    const meshlab_host::CameraMatrices camera = meshlab_host::cameraFromGl();
    const Eigen::Matrix4d layer = meshlab_host::layerTransform(mesh.cm);
    const laplacian_lines::View view = viewOf(camera, layer, chosen);

    QElapsedTimer clock;
    clock.start();
    lines.extractor->extract(view, chosen.style, scratch_, lines_);
    const double extraction = milliseconds(clock);

    if (chosen.show_statistics) glFinish();  // the mesh's own drawing must not count
    clock.restart();
    drawAll(lines, chosen, camera, layer, painter);
    if (!chosen.show_statistics) return {};
    glFinish();
    return statistics(lines_, extraction, milliseconds(clock));
}

void DecorateLaplacianLines::drawAll(const PreparedLines& lines, const DecorationParameters& chosen,
                                     const meshlab_host::CameraMatrices& camera,
                                     const Eigen::Matrix4d& layer, QPainter* painter) {
    const bool has_background = chosen.background == Background::Paper;
    const bool has_paint = chosen.surface.style != SurfaceAppearance::AsMeshLabDrawsIt;
    if (lines_.lines.empty() && !has_paint && !has_background) return;
    const Eigen::Matrix4d to_eye = camera.modelview * layer;
    surface_renderer_.drawDepth(lines.surface, layer);
    std::string failure;
    if (has_background) failure = background_renderer_.paint(chosen.surface.paper, painter);
    if (has_paint && failure.empty())
        failure = surface_renderer_.paint(lines.surface, layer, chosen.surface,
                                          lines.diagonal * meanScale(to_eye));
    if (failure.empty())
        failure = renderer_.draw(lines_, chosen.appearance,
                                 {to_eye, camera.projection, depth_bias * lines.diagonal});
    if (!failure.empty()) throw std::runtime_error(failure);
}

void DecorateLaplacianLines::complain(const MeshModel& mesh, const QString& text) {
    QString& last = complaints_[mesh.id()];
    if (text == last) return;
    last = text;
    say(QString("%1: %2: %3").arg(title, mesh.label(), text));
}

MESHLAB_PLUGIN_NAME_EXPORTER(DecorateLaplacianLines)
