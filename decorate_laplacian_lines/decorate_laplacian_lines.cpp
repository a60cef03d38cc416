// SPDX-License-Identifier: GPL-3.0-or-later
// MeshLab calls a decoration for one layer after the other:
//  start()  when it is switched on, and again after each filter and change of a parameter: prepares
//           the layer's lines, unless the cache has them.
//  draw()   in each redraw of a view:
//           1. Parameters out of range stay as they were.
//           2. Lines are prepared anew if the layer's geometry is no longer theirs.
//           3. The redraw's first layer asks for the printed drawing of the whole view. If the view
//              is at rest and it is ready, it is shown, and the lines of no layer are.
//           4. Else the lines that this camera sees are found and drawn over all surfaces.
//           5. What is refused, and why, is logged once, and stands in the view all the time.
//  end()    releases what it kept for the layer, or for the view if that is gone.
#include "decorate_laplacian_lines.h"

#include <QPainter>

#include "laplacian_lines/version.h"
#include "meshlab_host/camera.h"
#include "meshlab_host/documents.h"
#include "meshlab_host/drawn_style.h"
#include "meshlab_host/layer_drawing.h"
#include "redraw_mark.h"
#include "view_properties.h"

using line_renderer::RedrawClock;
using meshlab_host::CameraMatrices;

namespace {

const QString kTitle = "Laplacian Lines";

meshlab_host::DecorationDescription description() {
    const QString help =
        "Draws Laplacian lines: the zero crossings of the illumination's Laplacian, with the "
        "light at the eye, and the occluding contours. Run the filter Compute Laplacian Lines "
        "first to choose how they are computed; otherwise the default parameters are used. "
        "Version ";
    return {"DecorateLaplacianLines", kTitle, help + laplacian_lines::version() + '.'};
}

laplacian_lines::View view_of(const CameraMatrices& camera, const Eigen::Matrix4d& layer,
                              const DecorationParameters& chosen) {
    auto view = meshlab_host::view_from_matrices(camera.modelview, camera.projection, layer);
    if (const auto azimuth = light_azimuth(chosen))
        view.light = meshlab_host::direction_in_mesh(meshlab_host::towards_light(*azimuth),
                                                     camera.modelview, layer);
    return view;
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

QWidget* widget_of(QPainter* painter) {
    return painter ? dynamic_cast<QWidget*>(painter->device()) : nullptr;
}

double line_scale(QPainter* painter) {
    const QWidget* widget = widget_of(painter);
    const QVariant scale = widget ? widget->property(line_scale_property) : QVariant();
    return scale.isValid() ? scale.toDouble() : 1;
}

Eigen::Vector2i viewport_size() {
    GLint viewport[4] = {};
    glGetIntegerv(GL_VIEWPORT, viewport);
    return {viewport[2], viewport[3]};
}

/// Pixel, in a picture of `tiles` in a row, of the upper left corner of the tile being drawn.
Eigen::Vector2i corner_of(const Eigen::Matrix4d& projection, int tiles) {
    if (tiles == 1) return {0, 0};
    const Eigen::Array2d offset = meshlab_host::frustum_offset(projection);
    const Eigen::Array2d from_lower_left = (tiles - 1 - offset) / 2;
    const Eigen::Array2d tile(from_lower_left.x(), tiles - 1 - from_lower_left.y());
    return tile.round().cast<int>() * viewport_size().array();
}

double device_pixel_ratio(QPainter* painter) {
    return painter && painter->device() ? painter->device()->devicePixelRatioF() : 1;
}

/// Whether a layer is empty or has edges alone: no lines, and nothing that hides any.
bool draws_nothing(const MeshModel& layer) {
    return layer.cm.fn == 0 && (layer.cm.vn == 0 || layer.cm.en > 0);
}

/// Whether derivatives are missing, and computing them has not failed.
bool is_without_derivatives(const PreparedLines& lines) {
    return lines.extractor && !lines.has_derivatives && lines.missing_reason.isEmpty();
}

}  // namespace

DecorateLaplacianLines::DecorateLaplacianLines() : DecoratePluginBase(description()) {}

void DecorateLaplacianLines::list_parameters(RichParameterList& list) const {
    list_decoration_parameters(list);
}

ValidParameters DecorateLaplacianLines::valid_parameters(const RichParameterList& parameters) {
    ValidParameters valid = read_valid_parameters(parameters, last_good_);
    last_good_ = valid.as_set;
    return valid;
}

bool DecorateLaplacianLines::start(MeshModel& mesh, const RichParameterList& parameters,
                                   GLArea* view) {
    const ValidParameters valid = valid_parameters(parameters);
    // Not at redraws: MeshLab restarts decorations whenever a parameter changes.
    meshlab_host::note_drawn_style(drawn_style_of(valid.chosen));
    if (!has_looked_at_settings_) {
        const QString forgotten = forget_other_settings();
        if (!forgotten.isEmpty()) say(QString("%1: %2").arg(kTitle, forgotten));
    }
    has_looked_at_settings_ = true;
    QString refusal;
    try {
        const bool needs_derivatives = valid.chosen.style.shows.needs_derivatives();
        refusal = find_or_prepare_lines(mesh, view, needs_derivatives)->failure;
    } catch (const std::exception& error) {
        refusal = QString::fromUtf8(error.what());
    }
    if (refusal.isEmpty()) return true;
    const MeshDocument* document = meshlab_host::document_of(mesh);
    const GLLogStream* log = document ? &document->Log : nullptr;
    logged_refusals_.erase({log, int(mesh.id())});  // log it at each start
    log_refusal(mesh, log, refusal);
    return false;
}

void DecorateLaplacianLines::draw(MeshModel& mesh, const RichParameterList& parameters,
                                  GLArea* view, QPainter* painter, GLLogStream& log) {
    const ValidParameters valid = valid_parameters(parameters);
    QStringList complaints = valid.refused;
    QString text;
    if (shows_statistics_) glFinish();  // without the time of drawing the mesh itself
    RedrawClock clock;
    try {
        const bool needs_derivatives = valid.chosen.style.shows.needs_derivatives();
        PreparedLinesPointer lines = current_lines(mesh, view, painter);
        if (!lines || (needs_derivatives && is_without_derivatives(*lines))) {
            lines = find_or_prepare_lines(mesh, view, needs_derivatives);
            clock = RedrawClock();  // that has clocks of its own
        }
        if (lines->failure.isEmpty())
            text = draw_lines(mesh, *lines, valid.chosen, view, painter, clock);
        complaints << lines->failure << (needs_derivatives ? lines->missing_reason : QString());
    } catch (const std::exception& error) {
        complaints << QString::fromUtf8(error.what());
    }
    complaints.removeAll({});
    const QString refusal = complaints.join(" ");
    log_refusal(mesh, &log, refusal);
    log_new_layers(mesh, view);
    const QString& message = refusal.isEmpty() ? text : refusal;
    if (!message.isEmpty()) meshlab_host::write_on_view(log, kTitle, mesh.label(), message);
}

void DecorateLaplacianLines::end(MeshModel& mesh, GLArea* view) {
    cache_.release(view, mesh.id());
    prints_.forget(view);
}

void DecorateLaplacianLines::end_all(GLArea* view) {
    cache_.release_view(view);
    prints_.forget(view);
    drawing_.forget(view);
    logged_refusals_.clear();  // a new document may get the address of the old
}

void DecorateLaplacianLines::mesh_gone(GLArea* view) {
    cache_.release_unless_assigned(view);
    prints_.forget(view);
}

PreparedLinesPointer DecorateLaplacianLines::find_or_prepare_lines(MeshModel& mesh, GLArea* view,
                                                                   bool needs_derivatives) {
    if (const MeshDocument* document = meshlab_host::document_of(mesh))
        cache_.release_all_but(view, meshlab_host::layer_ids(*document));
    const meshlab_host::FieldSource source = meshlab_host::field_source(mesh.cm);
    const auto say_line = [this](const QString& line) { say(line); };
    const auto prepare = [&] {
        return prepare_lines(mesh.cm, mesh.label(),
                             needs_derivatives ? with_derivatives(source) : source, say_line);
    };
    PreparedLinesPointer lines = cache_.find(source.key);
    if (!lines || lines->is_out_of_memory) lines = prepare();
    if (lines->is_out_of_memory && kept_.drop()) lines = prepare();
    if (needs_derivatives && lines->extractor && !lines->has_derivatives) {
        prints_.interrupt();  // its thread may read the extractor
        add_derivatives(*lines, mesh.cm, mesh.label(), source, say_line);
    }
    cache_.assign(view, mesh.id(), lines);
    keep(mesh, lines);
    return lines;
}

void DecorateLaplacianLines::keep(const MeshModel& mesh, const PreparedLinesPointer& lines) {
    MeshDocument* const document = meshlab_host::document_of(mesh);
    if (!document) return;
    const auto [known, is_new] = known_layers_.try_emplace(document);
    if (is_new) {
        connect(document, &MeshDocument::meshSetChanged, this,
                [=] { kept_.forget_all_but(document, meshlab_host::layer_ids(*document)); });
        connect(document, &QObject::destroyed, this, [=] {
            kept_.forget_all_but(document, {});
            known_layers_.erase(document);
        });
        const std::vector<int> alive = meshlab_host::layer_ids(*document);
        known->second.insert(alive.begin(), alive.end());
    }
    known->second.insert(mesh.id());
    kept_.keep(document, mesh.id(), lines);
}

void DecorateLaplacianLines::log_new_layers(const MeshModel& mesh, GLArea* view) {
    const MeshDocument* document = meshlab_host::document_of(mesh);
    const auto known = known_layers_.find(document);
    if (known == known_layers_.end()) return;
    for (const MeshModel* layer : meshlab_host::layers_of(*document)) {
        if (layer->cm.fn == 0 || !layer->isVisible()) continue;
        if (!known->second.insert(int(layer->id())).second) continue;
        if (!cache_.at(view, layer->id()))
            say(QString("%1: %2 came later and has no lines yet: with it as the current layer, "
                        "switch on Render > %1")
                    .arg(kTitle, layer->label()));
    }
}

PreparedLinesPointer DecorateLaplacianLines::current_lines(const MeshModel& mesh, GLArea* view,
                                                           QPainter* painter) {
    PreparedLinesPointer lines = cache_.at(view, mesh.id());
    if (!lines || !meshlab_host::same_counts(lines->key.stamp, mesh.cm)) return nullptr;
    const Eigen::Matrix4d modelview = meshlab_host::camera_from_gl().modelview;
    const bool is_check_due = cache_.is_check_due(view, mesh.id(), modelview, widget_of(painter));
    if (is_check_due && meshlab_host::geometry_stamp(mesh.cm) != lines->key.stamp) return nullptr;
    return lines;
}

LayerInView DecorateLaplacianLines::layer_in_view(const MeshModel& mesh, const PreparedLines& lines,
                                                  const CameraMatrices& camera, int tiles,
                                                  GLArea* view, QPainter* painter) const {
    const Eigen::Matrix4d transform = meshlab_host::layer_transform(mesh.cm);
    const meshlab_host::LayerDrawing shown = meshlab_host::layer_drawing(mesh);
    LayerInView layer;
    layer.view = view;
    layer.widget = widget_of(painter);
    layer.mesh = mesh.id();
    layer.is_first = begins_redraw(painter);
    const MeshDocument* document = meshlab_host::document_of(mesh);
    if (layer.is_first && document) layer.shown = meshlab_host::layer_ids(*document, true);
    layer.modelview = camera.modelview;
    layer.surface = {lines.surface, transform, lines.diagonal, shown.culls_back_faces,
                     shown.has_faces && shown.mark_pixels == 0};
    layer.placement.to_eye = camera.modelview * transform;
    layer.placement.projection = camera.projection;
    layer.placement.diagonal = lines.diagonal;
    layer.placement.depth_bias_edge = lines.depth_bias_edge;
    layer.placement.mark_pixels = shown.mark_pixels;
    layer.placement.pixel_scale = device_pixel_ratio(painter) * line_scale(painter) * tiles;
    if (tiles > 1)
        layer.placement.picture_to_clip =
            tiles_.camera().projection * tiles_.camera().modelview * transform;
    return layer;
}

std::shared_ptr<PrintedScene> DecorateLaplacianLines::printed_scene(const MeshModel& mesh,
                                                                    ViewLayers::View view) const {
    std::vector<const MeshModel*> layers = {&mesh};
    if (const MeshDocument* document = meshlab_host::document_of(mesh))
        layers = meshlab_host::layers_of(*document);
    std::vector<LayerInScene> placed;
    PreparedLinesPointer first;
    std::size_t triangles = 0;
    for (const MeshModel* layer : layers) {
        if (!layer->isVisible() || draws_nothing(*layer)) continue;
        const PreparedLinesPointer lines = cache_.at(view, layer->id());
        if (!lines || !lines->printable) return nullptr;
        triangles += lines->printable->mesh.triangles.size();
        if (!first) first = lines;
        placed.push_back({lines->printable, meshlab_host::layer_transform(layer->cm)});
    }
    if (!first || triangles > PrintedScene::most_triangles) return nullptr;
    const std::shared_ptr<PrintedScene> shown = prints_.scene_of(view);
    if (shown && shown->is_of(placed)) return shown;
    if (!first->scene || !first->scene->is_of(placed))
        first->scene = std::make_shared<PrintedScene>(std::move(placed));
    return first->scene;
}

std::optional<PrintedView> DecorateLaplacianLines::printed_view(const MeshModel& mesh,
                                                                const DecorationParameters& chosen,
                                                                const LayerInView& layer,
                                                                int tiles) const {
    if (chosen.at_rest != AtRest::PrintedDrawing) return std::nullopt;
    const std::shared_ptr<PrintedScene> scene = printed_scene(mesh, layer.view);
    if (!scene) return std::nullopt;
    Eigen::Matrix4d projection = layer.placement.projection;
    if (tiles > 1) {
        projection = tiles_.camera().projection;
        projection.topRows<2>() /= tiles;
    }
    const double pen_mm =
        line_drawing::SheetOptions().pens[std::size_t(line_drawing::LineClass::Inner)];
    const Eigen::Matrix4d to_eye = layer.modelview * scene->to_world();
    auto window = window_of(to_eye, projection, tiles * viewport_size(),
                            chosen.line_width * layer.placement.pixel_scale / pen_mm);
    if (!window) return std::nullopt;
    return PrintedView{scene, to_eye, projection, *window, chosen};
}

Print DecorateLaplacianLines::request_print(const MeshModel& mesh,
                                            const DecorationParameters& chosen,
                                            const LayerInView& layer, int tiles) {
    const bool is_snapshot = snapshot_dialog_.take_accepted() || tiles > 1;
    const auto printed = printed_view(mesh, chosen, layer, tiles);
    if (!printed) {
        prints_.forget(layer.view);
        return {};
    }
    const bool waits =
        is_snapshot || (layer.widget && layer.widget->property(waits_property).toBool());
    Print print = prints_.request(layer.view, layer.widget, *printed, waits);
    if (!print.missing_reason.isEmpty())
        say(QString("%1: %2: %3").arg(kTitle, mesh.label(), print.missing_reason));
    return print;
}

QString DecorateLaplacianLines::draw_lines(const MeshModel& mesh, PreparedLines& lines,
                                           const DecorationParameters& chosen, GLArea* view,
                                           QPainter* painter, RedrawClock& clock) {
    shows_statistics_ = chosen.show_statistics;
    const CameraMatrices camera = meshlab_host::camera_from_gl();
    const laplacian_lines::View eye =
        view_of(camera, meshlab_host::layer_transform(mesh.cm), chosen);
    const int tiles = int(tiles_.scale(camera));
    const LayerInView layer = layer_in_view(mesh, lines, camera, tiles, view, painter);
    if (layer.is_first)
        print_ = request_print(mesh, chosen, layer, tiles);
    else if (print_.picture && layer.widget && printed_scene(mesh, view) != prints_.scene_of(view))
        layer.widget->update();  // this layer's lines have been prepared meanwhile
    if (!print_.picture) return draw_live_lines(lines, eye, layer, chosen, clock);
    drawing_.draw(layer, *print_.picture, corner_of(camera.projection, tiles), chosen);
    return chosen.show_statistics
               ? QString("printed drawing, %1 ms").arg(print_.milliseconds, 0, 'f', 0)
               : QString();
}

QString DecorateLaplacianLines::draw_live_lines(PreparedLines& lines,
                                                const laplacian_lines::View& eye,
                                                const LayerInView& layer,
                                                const DecorationParameters& chosen,
                                                RedrawClock& clock) {
    clock.count(RedrawClock::DrawCalls);
    lines.extractor->extract(eye, chosen.style, scratch_, lines_);
    clock.count(RedrawClock::Extraction);
    drawing_.draw(layer, lines_, chosen, clock);
    if (!lines.first_redraw) lines.first_redraw = clock.own_milliseconds();
    if (!chosen.show_statistics) return {};
    glFinish();
    clock.count(RedrawClock::Drawing);
    return statistics(lines_, clock, lines.preparation + *lines.first_redraw);
}

void DecorateLaplacianLines::log_refusal(const MeshModel& mesh, const GLLogStream* log,
                                         const QString& refusal) {
    QString& last = logged_refusals_[{log, int(mesh.id())}];
    if (!refusal.isEmpty() && refusal != last)
        say(QString("%1: %2: %3").arg(kTitle, mesh.label(), refusal));
    last = refusal;
}

MESHLAB_PLUGIN_NAME_EXPORTER(DecorateLaplacianLines)
