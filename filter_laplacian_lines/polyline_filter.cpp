// SPDX-License-Identifier: GPL-3.0-or-later
// The filter that makes a layer of lines: the strokes that a drawing of the view would have, or all
// lines of the view, also hidden ones.
#include "filters.h"

#include <Eigen/LU>
#include <QFileInfo>
#include <array>
#include <vector>

#include "laplacian_lines/error.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/refinement.h"
#include "line_drawing/object.h"
#include "line_drawing/view_strokes.h"
#include "meshlab_host/camera.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/documents.h"
#include "meshlab_host/edge_mesh.h"
#include "meshlab_host/field_source.h"
#include "meshlab_host/layer_drawing.h"
#include "meshlab_host/mesh_conversion.h"
#include "polyline_parameters.h"
#include "polyline_view.h"
#include "world_layers.h"

using laplacian_lines::LineSet;
using laplacian_lines::part;

namespace {

const char* const kFilterName = "Generate Laplacian Lines Polylines";

// Progress at the end of each step; of a drawing's strokes, and of all lines.
constexpr double kPlacedShare = 0.05, kStrokesShare = 0.95;
constexpr double kFieldShare = 0.7, kSightShare = 0.8, kExtractorShare = 0.95;

/// Copied from the layer, which may be deleted while the progress bar runs the event loop.
struct Source {
    explicit Source(const MeshModel& mesh)
        : triangles(meshlab_host::to_triangle_mesh(mesh.cm)),
          name(mesh.label()),
          to_world(meshlab_host::layer_transform(mesh.cm)) {}

    laplacian_lines::TriangleMesh triangles;
    QString name;
    Eigen::Matrix4d to_world;
};

/// D. Refuses meshes with vertices far off: triangles there are slivers, which count as without
/// area, but by rounding would hide all lines, and let the eye seem enclosed.
double drawn_diagonal(const Source& source) {
    constexpr double most = 1e6;  // diagonals of what has lines
    const double all = line_drawing::bounds_of(source.triangles).diagonal().stableNorm();
    const double drawn = laplacian_lines::measure_scale(source.triangles).diagonal;
    if (all > most * drawn)
        laplacian_lines::refuse(
            QString("The mesh is %1 across, but what can be drawn of it is %2: vertices lie far "
                    "off. Delete them and their faces first.")
                .arg(all)
                .arg(drawn)
                .toStdString(),
            laplacian_lines::ErrorCode::InvalidMesh);
    return drawn;
}

/// From world coordinates to those of the layer, whose D is `diagonal`.
LineSet line_set_of(std::vector<laplacian_lines::ViewLine> lines, const Source& source,
                    double diagonal) {
    LineSet set;
    set.origin = line_drawing::bounds_of(source.triangles).center();
    const Eigen::Affine3d to_layer(source.to_world.inverse());
    for (laplacian_lines::ViewLine& line : lines) {
        for (laplacian_lines::ViewLinePoint& point : line.points)
            point.position = to_layer * point.position;
        laplacian_lines::append(line, diagonal, set);
    }
    return set;
}

/// The strokes of a drawing, with the kernel that it would have; `diagonal`: of the layer.
LineSet strokes(const Source& source, const line_drawing::ViewFrame& frame,
                const PolylineParameters& chosen, const meshlab_host::FilterRun& run,
                double diagonal) {
    line_drawing::SheetOptions options;
    options.style = line_drawing::style_on_paper(chosen.style);
    if (chosen.light_azimuth) options.light = meshlab_host::towards_light(*chosen.light_azimuth);
    const WorldLayers placed =
        copy_layers({false, options.style.shows.needs_derivatives()}, run, kPlacedShare);
    return line_set_of(line_drawing::strokes_of(objects_of(placed), frame, options,
                                                part(run.progress, kPlacedShare, kStrokesShare)),
                       source, diagonal);
}

/// All lines of the view, also those that the surface hides.
LineSet all_lines(const Source& source, const line_drawing::ViewFrame& frame,
                  const PolylineParameters& chosen, const meshlab_host::FilterRun& run) {
    const laplacian_lines::View view = view_of(frame, chosen, source.to_world);
    const CMeshO& mesh = run.document.mm()->cm;
    meshlab_host::FieldSource field_source = meshlab_host::field_source(mesh);
    if (chosen.style.shows.needs_derivatives())
        field_source = meshlab_host::with_derivatives(std::move(field_source));
    const laplacian_lines::TriangleMesh triangles = laplacian_lines::refined(source.triangles);
    const laplacian_lines::Field field = meshlab_host::find_or_compute_field(
        mesh, triangles, source.name, field_source, run.say, part(run.progress, 0, kFieldShare));
    if (view.w != 0 &&
        laplacian_lines::LineVisibility(triangles, part(run.progress, kFieldShare, kSightShare))
            .encloses(view.eye / view.w))
        laplacian_lines::refuse(
            "The viewpoint is inside the surface. Move it outside, or choose an "
            "orthographic view.");
    const laplacian_lines::LineExtractor extractor(
        triangles, field, part(run.progress, kSightShare, kExtractorShare));
    laplacian_lines::ExtractionScratch scratch;
    LineSet lines;
    extractor.extract(view, chosen.style, scratch, lines);
    return lines;
}

void add_layer(const LineSet& lines, const Source& source, const meshlab_host::KindColors& colors,
               MeshDocument& document) {
    const QString name = QFileInfo(source.name).completeBaseName() + "_laplacian_lines";
    MeshModel* layer = document.addNewMesh("", name);
    layer->updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
    meshlab_host::to_edge_mesh(lines, layer->cm);
    meshlab_host::set_colors(lines, colors, layer->cm);
    meshlab_host::set_normals(source.triangles, layer->cm);
    layer->cm.Tr.FromEigenMatrix(source.to_world);
    meshlab_host::show_as_lines(document, layer->id());
}

/// "12 Laplacian lines, 1 ridge", without kinds that have none.
QString kinds_text(const LineSet& lines) {
    std::array<std::size_t, laplacian_lines::kLineKindCount> counts{};
    for (const auto& line : lines.lines)
        ++counts[std::size_t(line.kind)];
    QStringList parts;
    for (const auto& kind : laplacian_lines::kLineKinds)
        if (const std::size_t count = counts[std::size_t(kind.kind)])
            parts << counted(count, kind.one, kind.many);
    return parts.join(", ");
}

/// Records the eye, or the direction to it, for scripts; not how the window's picture was turned,
/// nor its axis in perspective. So the picture's size, which the kernel follows, may differ.
void record_view(const meshlab_host::FilterRun& run, PolylineParameters seen,
                 const line_drawing::ViewFrame& frame) {
    seen.view = frame.eye ? ViewChoice::Perspective : ViewChoice::Orthographic;
    seen.view_direction = frame.towards_viewer;
    seen.viewpoint = frame.eye.value_or(seen.viewpoint);
    RichParameterList recorded;
    list_polyline_parameters(seen, recorded);
    meshlab_host::record_as(kFilterName, recorded, run.document);
}

void list_parameters(const MeshModel* mesh, RichParameterList& list) {
    list_polyline_parameters(polyline_defaults(mesh, meshlab_host::current_view()), list);
}

void run(const meshlab_host::FilterRun& run) {
    const PolylineParameters chosen = read_polyline_parameters(run.parameters);
    const MeshModel& mesh = *run.document.mm();
    const Source source(mesh);
    Eigen::AlignedBox3d box = line_drawing::bounds_of(source.triangles);
    if (!box.isEmpty()) box.transform(Eigen::Affine3d(source.to_world));
    const auto frame = frame_of(chosen, box.center(), meshlab_host::current_view());
    const double diagonal = drawn_diagonal(source);
    const LineSet lines = chosen.visible_only ? strokes(source, frame, chosen, run, diagonal)
                                              : all_lines(source, frame, chosen, run);
    if (lines.lines.empty())
        laplacian_lines::refuse(
            "No lines are seen from there, so no layer was created. Take another view, "
            "more \"Detail\", or other \"Settings\".");
    laplacian_lines::report(run.progress, 1, "Adding a layer");
    add_layer(lines, source, chosen.colors, run.document);
    run.say(QString("Lines of %1: %2, %3 segments; %4")
                .arg(source.name, kinds_text(lines), QString::number(lines.segment_count()),
                     view_text(frame, chosen)));
    const QString warning = nearness_warning(frame, box);
    if (!warning.isEmpty()) run.say(warning);
    add_results(frame, run.results);
    run.results["sees_all"] = warning.isEmpty();
    if (chosen.view == ViewChoice::CurrentView) record_view(run, chosen, frame);
}

}  // namespace

meshlab_host::Filter polyline_filter() {
    return {
        {kFilterName, "generate_polyline_from_laplacian_lines",
         "Creates a layer with the lines of the current layer as seen from one view, that of the "
         "window or another: vertices and edges, for other filters and programs (OBJ, DXF), with "
         "attributes <b>ll_...</b> that tell more about them.",
         meshlab_host::FilterInterface::Normal | meshlab_host::FilterInterface::Layer},
        list_parameters,
        run};
}
