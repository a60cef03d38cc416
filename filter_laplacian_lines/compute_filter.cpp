// SPDX-License-Identifier: GPL-3.0-or-later
// The filter that computes the field and stores it in the mesh's attributes; its log tells what was
// done to the mesh.
#include "filters.h"

#include <QElapsedTimer>
#include <string>
#include <vector>

#include "laplacian_lines/error.h"
#include "laplacian_lines/option_table.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/version.h"
#include "meshlab_host/field_attributes.h"
#include "meshlab_host/field_source.h"
#include "meshlab_host/mesh_conversion.h"
#include "meshlab_host/parameters.h"

using laplacian_lines::Field;
using laplacian_lines::FieldScale;
using laplacian_lines::MeshReport;
using laplacian_lines::PrecomputeOptions;

namespace {

/// The rows of the core's table that the filter offers; others keep their defaults.
const auto& option_table() {
    static const auto table = [] {
        std::vector<laplacian_lines::OptionRow<PrecomputeOptions>> rows;
        for (const std::string key :
             {"kernel_size", "normal_smoothing", "normal_sigma", "weld_duplicates",
              "laplace_operator", "gradient_estimator", "curvature_derivatives"})
            for (const auto& row : laplacian_lines::precompute_option_table())
                if (row.key == key) rows.push_back(row);
        return rows;
    }();
    return table;
}

/// Stores the field. @throws Error(FieldMismatch) if the mesh was deleted or edited while the
/// progress bar ran the event loop
void store(MeshDocument& document, int mesh_id, const meshlab_host::GeometryStamp& stamp,
           const Field& field, const PrecomputeOptions& options) {
    MeshModel* mesh = document.getMesh(mesh_id);
    if (!mesh || meshlab_host::geometry_stamp(mesh->cm) != stamp)
        laplacian_lines::refuse(
            "The mesh changed while its field was being computed. Run the filter again.",
            laplacian_lines::ErrorCode::FieldMismatch);
    meshlab_host::write_field(mesh->cm, field, options, stamp);
}

QString mesh_line(const MeshReport& report) {
    return QString("Laplacian lines: %1 vertices, %2 triangles")
        .arg(report.vertices)
        .arg(report.triangles);
}

/// Empty if the report counts nothing as dropped.
QString dropped_line(const MeshReport& report) {
    QStringList parts;
    if (report.non_finite_vertices)
        parts << counted(report.non_finite_vertices, "vertex with non-finite coordinates",
                         "vertices with non-finite coordinates");
    if (report.degenerate_triangles)
        parts << counted(report.degenerate_triangles, "triangle without a finite area",
                         "triangles without a finite area");
    if (report.unreferenced_vertices)
        parts << counted(report.unreferenced_vertices, "vertex without triangles",
                         "vertices without triangles");
    return parts.isEmpty() ? QString() : "Left out: " + parts.join(", ");
}

QString welded_line(const MeshReport& report) {
    return report.welded_vertices
               ? "Cuts, cracks and sides without length closed: " +
                     counted(report.welded_vertices, "vertex treated as one with another",
                             "vertices treated as one with others")
               : QString();
}

QString kernel_line(const FieldScale& scale) {
    return QString(
               "Kernel size %1 in mesh units = %2 mean edges = %3 % of the bounding-box diagonal")
        .arg(scale.kernel_size, 0, 'g', 5)
        .arg(scale.kernel_size / scale.mean_edge, 0, 'f', 2)
        .arg(100 * scale.kernel_size / scale.diagonal, 0, 'f', 2);
}

QString smoothing_line(const Field& field, const PrecomputeOptions& options) {
    const double sigma = field.scale.normal_sigma / field.scale.mean_edge;
    const bool is_automatic = options.normal_sigma == 0 &&
                              options.normal_smoothing != laplacian_lines::NormalSmoothing::None;
    return (is_automatic ? QString("Roughness %1, normals").arg(field.report.roughness, 0, 'f', 2)
                         : QString("Normals")) +
           (sigma > 0 ? QString(" smoothed by %1 mean edges").arg(sigma, 0, 'f', 2)
                      : QString(" as they are"));
}

/// "Normal Smoothing: Gaussian, ..."
QString choices_line(const PrecomputeOptions& options) {
    QStringList parts;
    for (const auto& row : option_table())
        if (row.kind == laplacian_lines::OptionKind::Choice)
            parts << QString("%1: %2").arg(row.label, row.choices[std::size_t(row.get(options))]);
    return parts.join(", ");
}

/// Without lines that have nothing to report.
QStringList compute_report(const Field& field, const PrecomputeOptions& options, double seconds) {
    QStringList lines{mesh_line(field.report),        dropped_line(field.report),
                      welded_line(field.report),      kernel_line(field.scale),
                      smoothing_line(field, options), choices_line(options)};
    lines << QString("Computed in %1 s, stored per vertex in %2")
                 .arg(seconds, 0, 'f', 2)
                 .arg(meshlab_host::field_attribute_names(field));
    lines.removeAll(QString());
    return lines + meshlab_host::mesh_advice(field.report);
}

void list_parameters(const MeshModel* mesh, RichParameterList& list) {
    const double diagonal = mesh ? double(mesh->cm.bbox.Diag()) : 0;
    for (const auto& row : option_table())
        meshlab_host::add_parameter(row, row.value(PrecomputeOptions()), list, diagonal);
}

void run(const meshlab_host::FilterRun& run) {
    QElapsedTimer clock;
    clock.start();
    PrecomputeOptions options;
    for (const auto& row : option_table())
        meshlab_host::read_parameter(row, options, run.parameters);
    const CMeshO& mesh = run.document.mm()->cm;
    const int mesh_id = run.document.mm()->id();
    const meshlab_host::GeometryStamp stamp = meshlab_host::geometry_stamp(mesh);
    const Field field =
        laplacian_lines::precompute(meshlab_host::to_triangle_mesh(mesh), options, run.progress);
    store(run.document, mesh_id, stamp, field, options);
    for (const QString& line : compute_report(field, options, 1e-3 * double(clock.elapsed())))
        run.say(line);
}

}  // namespace

meshlab_host::Filter compute_filter() {
    return {
        {"Compute Laplacian Lines", "compute_laplacian_lines_per_vertex",
         QStringLiteral(
             "Chooses how the surface is analysed; without this filter, Render &gt; <b>Laplacian "
             "Lines</b> takes the defaults. The result is in per-vertex attributes <b>ll_...</b>, "
             "until the mesh changes.<br>"
             "After Zhang, He, Xie and Chen, <i>Laplacian Lines for Real-Time Shape "
             "Illustration</i>, 2009. Version ") +
             laplacian_lines::version() + '.',
         meshlab_host::FilterInterface::Normal | meshlab_host::FilterInterface::Quality},
        list_parameters,
        run};
}
