// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared_lines.h"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <new>
#include <tuple>

#include "laplacian_lines/option_table.h"
#include "laplacian_lines/precompute.h"
#include "meshlab_host/mesh_conversion.h"

using laplacian_lines::Field;
using laplacian_lines::PrecomputeOptions;
using laplacian_lines::TriangleMesh;
using meshlab_host::FieldStatus;

namespace {

std::vector<double> optionValues(const PrecomputeOptions& options) {
    std::vector<double> values;
    for (const auto& row : laplacian_lines::precompute_option_table())
        values.push_back(row.get(options));
    return values;
}

/// An hourglass while the GUI thread is busy.
class WaitCursor {
public:
    WaitCursor() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
    ~WaitCursor() { QGuiApplication::restoreOverrideCursor(); }
    WaitCursor(const WaitCursor&) = delete;
    WaitCursor& operator=(const WaitCursor&) = delete;
};

QString computedLine(const QString& mesh_name, FieldStatus status, double seconds) {
    return QString(
               "Laplacian Lines: %1 has %2; computed with the default options in %3 s (to "
               "choose others, run the filter Compute Laplacian Lines)")
        .arg(mesh_name, meshlab_host::describe(status))
        .arg(seconds, 0, 'f', 2);
}

Field fieldOf(const CMeshO& mesh, const TriangleMesh& triangles, const QString& mesh_name,
              const LineSource& source, const std::function<void(const QString&)>& say) {
    if (source.status == FieldStatus::Current)
        if (std::optional<Field> field = meshlab_host::readField(mesh, source.key.stamp))
            return std::move(*field);
    QElapsedTimer clock;
    clock.start();
    Field field = laplacian_lines::precompute(triangles, source.options);
    say(computedLine(mesh_name, source.status, 1e-3 * double(clock.elapsed())));
    return field;
}

}  // namespace

bool LineKey::operator<(const LineKey& other) const {
    const auto order = [](const LineKey& key) {
        return std::tie(key.stamp.hash, key.stamp.vertices, key.stamp.faces, key.options);
    };
    return order(*this) < order(other);
}

LineSource lineSource(const CMeshO& mesh) {
    LineSource source;
    source.key.stamp = meshlab_host::geometryStamp(mesh);
    source.status = meshlab_host::fieldStatus(mesh, source.key.stamp);
    if (source.status == FieldStatus::Current)
        source.options = meshlab_host::readFieldRecord(mesh)->options;
    source.key.options = optionValues(source.options);
    return source;
}

PreparedLinesPointer prepareLines(const CMeshO& mesh, const QString& mesh_name,
                                  const LineSource& source,
                                  const std::function<void(const QString&)>& say) {
    auto result = std::make_shared<PreparedLines>();
    result->key = source.key;
    try {
        const WaitCursor wait_cursor;
        const TriangleMesh triangles = meshlab_host::toTriangleMesh(mesh);
        const Field field = fieldOf(mesh, triangles, mesh_name, source, say);
        result->diagonal = field.scale.diagonal;
        result->mean_edge = field.scale.mean_edge;
        result->surface = makeSurface(triangles, field);
        result->extractor.emplace(triangles, field);
    } catch (const std::bad_alloc&) {
        result->failure = "There is not enough memory for the lines of this mesh.";
    } catch (const std::exception& error) {
        result->failure = QString::fromUtf8(error.what());
    }
    return result;
}
