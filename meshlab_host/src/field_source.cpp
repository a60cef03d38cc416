// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/field_source.h"

#include <QElapsedTimer>
#include <tuple>

#include "laplacian_lines/mesh_faults.h"
#include "laplacian_lines/option_table.h"
#include "laplacian_lines/precompute.h"

namespace meshlab_host {

using laplacian_lines::Field;

namespace {

/// Without the derivatives, which change nothing else.
std::vector<double> option_values(laplacian_lines::PrecomputeOptions options) {
    options.curvature_derivatives = false;
    std::vector<double> values;
    for (const auto& row : laplacian_lines::precompute_option_table())
        values.push_back(row.get(options));
    return values;
}

/// What was done for this mesh, each after a comma; empty for clean ones.
QString automatic_steps_of(const Field& field, std::size_t faces) {
    QString steps;
    if (field.report.triangles != faces)
        steps += QString(", for %1 triangles instead of %2").arg(field.report.triangles).arg(faces);
    if (field.report.welded_vertices)
        steps += QString(", %1 vertices welded at cuts, cracks and sides without length")
                     .arg(field.report.welded_vertices);
    if (field.report.roughness > 0 && field.scale.normal_sigma > 0)
        steps += QString(", roughness %1: normals smoothed by %2 % of the diagonal")
                     .arg(field.report.roughness, 0, 'f', 2)
                     .arg(100 * field.scale.normal_sigma / field.scale.diagonal, 0, 'f', 2);
    return steps;
}

QString computed_line(const QString& mesh_name, FieldStatus status, const Field& field,
                      std::size_t faces, double seconds) {
    const bool has_attributes = status == FieldStatus::Current;
    return QString("Laplacian Lines: %1%2: computed with the %3 in %4 s%5%6")
        .arg(mesh_name, describe(status),
             has_attributes ? "options of its attributes" : "default options",
             QString::number(seconds, 'f', 2), automatic_steps_of(field, faces),
             has_attributes ? "" : " (the filter Compute Laplacian Lines has others)");
}

}  // namespace

bool FieldKey::operator<(const FieldKey& other) const {
    const auto order = [](const FieldKey& key) {
        return std::tie(key.stamp.hash, key.stamp.vertices, key.stamp.faces, key.options);
    };
    return order(*this) < order(other);
}

QStringList mesh_advice(const laplacian_lines::MeshReport& report) {
    QStringList lines;
    for (const laplacian_lines::MeshFault fault : laplacian_lines::faults_of(report))
        lines << "Warning: " + QString::fromStdString(describe(fault, report));
    return lines;
}

FieldSource field_source(const CMeshO& mesh) {
    FieldSource source;
    source.key.stamp = geometry_stamp(mesh);
    source.status = field_status(mesh, source.key.stamp);
    if (source.status == FieldStatus::Current) source.options = read_field_record(mesh)->options;
    source.key.options = option_values(source.options);
    return source;
}

FieldSource with_derivatives(FieldSource source) {
    source.options.curvature_derivatives = true;
    return source;
}

bool is_stored(const CMeshO& mesh, const laplacian_lines::TriangleMesh& triangles,
               const FieldSource& source) {
    // undone and refined again, a subdivided mesh may have as many triangles as before
    return source.status == FieldStatus::Current && triangles.known_edge == 0 &&
           triangles.triangles.size() == std::size_t(mesh.fn);
}

Field find_or_compute_field(const CMeshO& mesh, const laplacian_lines::TriangleMesh& triangles,
                            const QString& mesh_name, const FieldSource& source,
                            const std::function<void(const QString&)>& say,
                            const laplacian_lines::Progress& progress) {
    const auto faces = std::size_t(mesh.fn);  // the mesh may go while its field is computed
    if (is_stored(mesh, triangles, source))
        if (std::optional<Field> field = read_field(mesh, source.key.stamp)) {
            if (source.options.curvature_derivatives)
                ensure_derivatives(triangles, *field, progress);
            return std::move(*field);
        }
    QElapsedTimer clock;
    clock.start();
    Field field = laplacian_lines::precompute(triangles, source.options, progress);
    say(computed_line(mesh_name, source.status, field, faces, 1e-3 * double(clock.elapsed())));
    for (const QString& line : mesh_advice(field.report))
        say(mesh_name + ": " + line);
    return field;
}

void ensure_derivatives(const laplacian_lines::TriangleMesh& triangles, Field& field,
                        const laplacian_lines::Progress& progress) {
    if (!field.has_derivatives())
        laplacian_lines::add_curvature_derivatives(triangles, field, progress);
}

}  // namespace meshlab_host
