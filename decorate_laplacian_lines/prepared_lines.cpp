// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared_lines.h"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <new>
#include <utility>

#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/line_visibility.h"
#include "meshlab_host/mesh_conversion.h"
#include "printed_scene.h"

using laplacian_lines::Field;
using laplacian_lines::TriangleMesh;

namespace {

/// Memory of a scene once it has been printed, in that of the extractor.
constexpr std::size_t kSceneShare = 4;

class WaitCursor {
public:
    WaitCursor() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
    ~WaitCursor() { QGuiApplication::restoreOverrideCursor(); }
    WaitCursor(const WaitCursor&) = delete;
    WaitCursor& operator=(const WaitCursor&) = delete;
};

std::size_t bytes_of(const PreparedLines& lines) {
    std::size_t sum = lines.extractor->memory() * (lines.printable ? 1 + kSceneShare : 1) +
                      line_renderer::bytes_of(*lines.surface);
    if (lines.field)
        for (const auto& column : laplacian_lines::present_columns(*lines.field))
            sum += column.size(*lines.field) * std::size_t(column.floats) * sizeof(float);
    return sum;
}

}  // namespace

PreparedLinesPointer prepare_lines(const CMeshO& mesh, const QString& mesh_name,
                                   const meshlab_host::FieldSource& source,
                                   const std::function<void(const QString&)>& say) {
    QElapsedTimer clock;
    clock.start();
    auto result = std::make_shared<PreparedLines>();
    result->key = source.key;
    try {
        const WaitCursor wait_cursor;
        TriangleMesh triangles = meshlab_host::to_drawn_mesh(mesh);
        Field field = meshlab_host::find_or_compute_field(mesh, triangles, mesh_name, source, say);
        result->diagonal = field.scale.diagonal;
        result->depth_bias_edge = laplacian_lines::depth_bias_edge(field);
        result->surface = line_renderer::make_surface(triangles, field);
        result->extractor = std::make_shared<laplacian_lines::LineExtractor>(triangles, field);
        result->has_derivatives = field.has_derivatives();
        const double kernel = field.scale.kernel_size;
        const bool is_in_mesh = meshlab_host::is_stored(mesh, triangles, source);
        if (!is_in_mesh && !result->has_derivatives) result->field = std::move(field);
        if (triangles.triangles.size() <= PrintedScene::most_triangles)
            result->printable = std::make_shared<PrintableMesh>(PrintableMesh{
                std::move(triangles), is_in_mesh ? std::optional(std::move(field)) : std::nullopt,
                source.options, result->extractor, kernel});
        result->bytes = bytes_of(*result);
    } catch (const std::bad_alloc&) {
        result->extractor.reset();  // it may have been made before
        result->failure = "There is not enough memory for the lines of this mesh.";
        result->is_out_of_memory = true;
    } catch (const std::exception& error) {
        result->failure = QString::fromUtf8(error.what());
    }
    result->preparation = 1e-6 * double(clock.nsecsElapsed());
    return result;
}

void add_derivatives(PreparedLines& lines, const CMeshO& mesh, const QString& mesh_name,
                     const meshlab_host::FieldSource& source,
                     const std::function<void(const QString&)>& say) {
    QElapsedTimer clock;
    clock.start();
    try {
        const WaitCursor wait_cursor;
        const TriangleMesh triangles = meshlab_host::to_drawn_mesh(mesh);
        Field found;
        if (lines.field)
            meshlab_host::ensure_derivatives(triangles, *lines.field);
        else
            found = meshlab_host::find_or_compute_field(
                mesh, triangles, mesh_name, meshlab_host::with_derivatives(source), say);
        lines.extractor->add_derivatives(triangles, lines.field ? *lines.field : found);
        lines.field.reset();
        lines.has_derivatives = true;
        lines.missing_reason.clear();
        say(QString("Laplacian Lines: %1: computed in %2 s what the chosen kinds of lines also "
                    "need")
                .arg(mesh_name, QString::number(1e-3 * double(clock.elapsed()), 'f', 2)));
    } catch (const std::bad_alloc&) {
        lines.missing_reason = "There is not enough memory for some of the chosen kinds of lines.";
    } catch (const std::exception& error) {
        lines.missing_reason = QString::fromUtf8(error.what());
    }
    lines.bytes = bytes_of(lines);
}
