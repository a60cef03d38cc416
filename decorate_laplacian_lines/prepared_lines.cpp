// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared_lines.h"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <new>

#include "laplacian_lines/line_visibility.h"
#include "meshlab_host/mesh_conversion.h"

using laplacian_lines::Field;
using laplacian_lines::TriangleMesh;

namespace {

/// Share of the time that computing the field takes; the rest is building the extractor.
constexpr double field_share = 0.65;

/// An hourglass while the GUI thread is busy.
class WaitCursor {
public:
    WaitCursor() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
    ~WaitCursor() { QGuiApplication::restoreOverrideCursor(); }
    WaitCursor(const WaitCursor&) = delete;
    WaitCursor& operator=(const WaitCursor&) = delete;
};

}  // namespace

PreparedLinesPointer prepareLines(const CMeshO& mesh, const QString& mesh_name,
                                  const meshlab_host::FieldSource& source,
                                  const std::function<void(const QString&)>& say,
                                  meshlab_host::WindowProgress* shown) {
    const auto step = [&](double begin, double end) {
        return shown ? shown->step(begin, end) : laplacian_lines::Progress();
    };
    QElapsedTimer clock;
    clock.start();
    auto result = std::make_shared<PreparedLines>();
    result->key = source.key;
    result->has_derivatives = source.options.curvature_derivatives;
    try {
        const WaitCursor wait_cursor;
        const TriangleMesh triangles = meshlab_host::toTriangleMesh(mesh);
        const Field field = meshlab_host::demandField(mesh, triangles, mesh_name, source, say,
                                                      step(0, field_share));
        result->diagonal = field.scale.diagonal;
        result->sight_edge = laplacian_lines::sight_edge(field);
        result->surface = line_renderer::makeSurface(triangles, field);
        result->extractor.emplace(triangles, field, step(field_share, 1));
        result->bytes = result->extractor->memory() + line_renderer::bytesOf(*result->surface);
    } catch (const std::bad_alloc&) {
        result->failure = "There is not enough memory for the lines of this mesh.";
        result->lacked_memory = true;
    } catch (const std::exception& error) {
        result->failure = QString::fromUtf8(error.what());
    }
    result->preparation = 1e-6 * double(clock.nsecsElapsed());
    return result;
}
