// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing_filter.h"

#include <QFileInfo>
#include <cmath>

#include "drawing_sheet.h"
#include "filter_help.h"
#include "laplacian_lines/precompute.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/sheet_file.h"
#include "meshlab_host/camera.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/field_source.h"
#include "meshlab_host/mesh_conversion.h"
#include "meshlab_host/progress.h"
#include "placed_mesh.h"
#include "polyline_view.h"

using line_drawing::Sheet;
using line_drawing::SheetOptions;

namespace {

// What is done of the work when each step has ended.
constexpr double field_share = 0.4, sheet_share = 0.98;

/// A layer as it stands in the world, copied: it may go while the progress bar runs the event loop.
struct Placed {
    laplacian_lines::TriangleMesh mesh;
    laplacian_lines::Field field;
};

/// A field cannot follow a layer that is stretched: that of its result is computed.
laplacian_lines::Field fieldOfStretched(const laplacian_lines::TriangleMesh& mesh, double factor,
                                        laplacian_lines::PrecomputeOptions options,
                                        const meshlab_host::FilterRun& run) {
    run.say("The layer's transformation stretches it: its lines are computed anew, as it stands.");
    options.kernel_size *= factor;
    return laplacian_lines::precompute(mesh, options,
                                       meshlab_host::progressTo(run.progress, 0, field_share));
}

Placed placeInWorld(const MeshModel& layer, const meshlab_host::FilterRun& run) {
    const Eigen::Matrix4d transform = meshlab_host::layerTransform(layer.cm);
    const std::optional<Similarity> similarity = similarityOf(transform);
    const meshlab_host::FieldSource source = meshlab_host::fieldSource(layer.cm);
    Placed result{meshlab_host::toTriangleMesh(layer.cm), {}};
    if (!similarity) {
        place(transform, result.mesh);
        const double factor = std::cbrt(std::abs(transform.topLeftCorner<3, 3>().determinant()));
        result.field = fieldOfStretched(result.mesh, factor, source.options, run);
        return result;
    }
    result.field =
        meshlab_host::demandField(layer.cm, result.mesh, layer.label(), source, run.say,
                                  meshlab_host::progressTo(run.progress, 0, field_share));
    if (transform.isIdentity(0)) return result;
    place(transform, result.mesh);
    const bool has_derivatives = !result.field.curvature_derivatives.empty();
    place(*similarity, result.field);
    if (has_derivatives) laplacian_lines::add_curvature_derivatives(result.mesh, result.field);
    return result;
}

QString lengths(const Eigen::Vector3d& size) {
    return QString("%1 x %2 x %3 mm").arg(size.x()).arg(size.y()).arg(size.z());
}

/// Name, scale and paper of what was drawn, and how large the object was taken to be.
QString report(const QString& object, const QString& file, const Sheet& sheet,
               const Eigen::Vector3d& size, const SheetOptions& options) {
    return QString(
               "Drawing of %1: %2, scale %3 on paper of %4 x %5 mm. The object is %6 large, with "
               "%7 mm to the unit of the mesh.")
        .arg(object, file, line_drawing::scaleInWords(sheet.scale))
        .arg(sheet.size.width())
        .arg(sheet.size.height())
        .arg(lengths(size))
        .arg(options.mm_per_unit);
}

}  // namespace

meshlab_host::FilterDescription DrawingFilter::description() const {
    meshlab_host::FilterDescription result;
    result.name = "Export Laplacian Lines Drawing";
    result.python_name = "export_laplacian_lines_drawing";
    result.help = drawingHelp();
    result.filter_class = meshlab_host::FilterInterface::Normal;
    result.preconditions = MeshModel::MM_FACENUMBER;
    return result;
}

void DrawingFilter::listParameters(const MeshModel* mesh, RichParameterList& list) const {
    const bool has_window = meshlab_host::currentView().has_value();
    listDrawingParameters(drawingDefaults(mesh, has_window), list);
}

std::vector<meshlab_host::ParameterDescription> DrawingFilter::describeParameters() const {
    return describeDrawingParameters();
}

void DrawingFilter::run(const meshlab_host::FilterRun& run) const {
    const DrawingParameters chosen = readDrawingParameters(run.parameters);
    line_drawing::checkSheetFile(chosen.file);
    const std::optional<meshlab_host::CurrentView> window = meshlab_host::currentView();
    SheetOptions options = sheetOptions(chosen, window);
    if (usesWindow(chosen) && !window->is_orthographic)
        run.say("The window shows perspective; drawn is what parallel rays along its view show.");
    const QString object = run.document.mm()->label();
    options.source = object;
    Placed placed = placeInWorld(*run.document.mm(), run);
    if (options.style.shows.needs_derivatives() && placed.field.curvature_derivatives.empty())
        laplacian_lines::add_curvature_derivatives(placed.mesh, placed.field);
    const Sheet sheet =
        line_drawing::makeSheet(placed.mesh, placed.field, options,
                                meshlab_host::progressTo(run.progress, field_share, sheet_share));
    meshlab_host::beginStep(run.progress, 1, "Writing the drawing");
    line_drawing::writeSheet(sheet, chosen.file);
    const QString file = QFileInfo(chosen.file).absoluteFilePath();
    const Eigen::Vector3d size = options.mm_per_unit * boxOf(placed.mesh).sizes();
    run.say(report(object, file, sheet, size, options));
    run.results["file"] = file;
    run.results["scale"] = sheet.scale;
    meshlab_host::addResult("paper", {sheet.size.width(), sheet.size.height(), 0}, run.results);
    meshlab_host::addResult("object", size, run.results);
}
