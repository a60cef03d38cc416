// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters.h"

#include <QElapsedTimer>
#include <cmath>

#include "compute_filter.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/option_table.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/version.h"
#include "line_drawing/object.h"
#include "meshlab_host/field_attributes.h"
#include "meshlab_host/mesh_conversion.h"
#include "meshlab_host/parameters.h"
#include "meshlab_host/progress.h"

using laplacian_lines::Error;
using laplacian_lines::ErrorCode;
using laplacian_lines::Field;
using laplacian_lines::FieldScale;
using laplacian_lines::PrecomputeOptions;
using laplacian_lines::TriangleMesh;

namespace {

const QString key_prefix;  // scripts use the keys of the option table as they are

/// Of a large mesh, near enough to be shown.
FieldScale scaleByCopy(const TriangleMesh& coarse_copy) {
    PrecomputeOptions as_it_is;
    as_it_is.weld_duplicates = false;  // of the copy's triangles, which do not touch
    FieldScale scale = laplacian_lines::measure_scale(coarse_copy, as_it_is);
    scale.diagonal = line_drawing::boundsOf(coarse_copy).diagonal().norm();
    scale.kernel_size = laplacian_lines::automatic_kernel_size(scale.mean_edge, scale.diagonal);
    return scale;
}

/// For the defaults; zeros if the mesh is unusable, which the filter itself explains.
FieldScale defaultScale(const MeshModel* mesh) {
    if (!mesh) return {};
    try {
        if (const std::optional<TriangleMesh> copy = coarseCopy(mesh->cm))
            return scaleByCopy(*copy);
        return laplacian_lines::measure_scale(meshlab_host::toTriangleMesh(mesh->cm));
    } catch (const std::exception&) {
        return {};
    }
}

/// Large meshes show an estimate as default; a user who leaves it wants the exact value.
void measureAnew(const CMeshO& mesh, PrecomputeOptions& options) {
    constexpr double as_shown = 1e-4;  // share by which a text may differ from its number
    if (options.kernel_size == 0) return;
    const std::optional<TriangleMesh> copy = coarseCopy(mesh);
    if (!copy) return;
    const double shown = scaleByCopy(*copy).kernel_size;
    if (std::abs(options.kernel_size - shown) <= as_shown * shown) options.kernel_size = 0;
}

/// Unless the mesh was deleted or edited while the progress bar ran the event loop: a field must
/// never end up on another geometry.
void store(MeshDocument& document, int mesh_id, const meshlab_host::GeometryStamp& stamp,
           const Field& field, const PrecomputeOptions& options) {
    MeshModel* mesh = document.getMesh(mesh_id);
    if (!mesh || meshlab_host::geometryStamp(mesh->cm) != stamp)
        throw Error(ErrorCode::FieldMismatch,
                    "The mesh changed while its lines were being computed. Run the filter again.");
    meshlab_host::writeField(mesh->cm, field, options, stamp);
}

}  // namespace

meshlab_host::FilterDescription ComputeFilter::description() const {
    meshlab_host::FilterDescription result;
    result.name = "Compute Laplacian Lines";
    result.python_name = "compute_laplacian_lines_per_vertex";
    result.help =
        QStringLiteral(
            "Chooses how the surface is analysed for Laplacian lines, once for all views. To see "
            "them, switch on <b>Laplacian Lines</b> in the Render menu; without this filter, that "
            "does the same with the default parameters.<br>"
            "The mesh is not changed: the result is in per-vertex attributes <b>ll_...</b>, until "
            "the mesh changes. Cuts whose sides only nearly meet leave lines along them: run "
            "<i>Merge Close Vertices</i> first.<br>"
            "After Zhang, He and Seah, <i>Laplacian Lines for Real-Time Shape Illustration</i>, "
            "2009. Version ") +
        laplacian_lines::version() + '.';
    result.filter_class =
        meshlab_host::FilterInterface::Normal | meshlab_host::FilterInterface::Quality;
    result.preconditions = MeshModel::MM_FACENUMBER;
    return result;
}

void ComputeFilter::listParameters(const MeshModel* mesh, RichParameterList& list) const {
    const FieldScale scale = defaultScale(mesh);
    PrecomputeOptions defaults;
    defaults.kernel_size = scale.kernel_size;  // shown as a number; 0 in scripts means the same
    meshlab_host::addParameters(laplacian_lines::precompute_option_table(), defaults,
                                scale.diagonal, key_prefix, list);
}

std::vector<meshlab_host::ParameterDescription> ComputeFilter::describeParameters() const {
    std::vector<meshlab_host::ParameterDescription> result;
    for (const auto& row : laplacian_lines::precompute_option_table())
        result.push_back(meshlab_host::describe(row, key_prefix));
    return result;
}

void ComputeFilter::run(const meshlab_host::FilterRun& run) const {
    QElapsedTimer clock;
    clock.start();
    PrecomputeOptions options = meshlab_host::readOptions(
        laplacian_lines::precompute_option_table(), key_prefix, run.parameters);
    const CMeshO& mesh = run.document.mm()->cm;
    measureAnew(mesh, options);
    const int mesh_id = run.document.mm()->id();
    const meshlab_host::GeometryStamp stamp = meshlab_host::geometryStamp(mesh);
    const Field field = laplacian_lines::precompute(meshlab_host::toTriangleMesh(mesh), options,
                                                    meshlab_host::progressTo(run.progress));
    store(run.document, mesh_id, stamp, field, options);
    for (const QString& line : computeReport(field, options, 1e-3 * double(clock.elapsed())))
        run.say(line);
}
