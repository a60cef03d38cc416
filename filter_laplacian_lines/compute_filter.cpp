// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters.h"

#include <QElapsedTimer>
#include <string>

#include "compute_filter.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/option_table.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/version.h"
#include "meshlab_host/field_attributes.h"
#include "meshlab_host/mesh_conversion.h"
#include "meshlab_host/parameters.h"
#include "meshlab_host/progress.h"

using laplacian_lines::Error;
using laplacian_lines::ErrorCode;
using laplacian_lines::Field;
using laplacian_lines::PrecomputeOptions;

namespace {

const QString key_prefix;  // scripts use the keys of the option table as they are

/// Of the core's table. The others keep their defaults here.
std::vector<laplacian_lines::OptionDescription<PrecomputeOptions>> makeTable() {
    std::vector<laplacian_lines::OptionDescription<PrecomputeOptions>> rows;
    for (const std::string key :
         {"kernel_size", "kernel_mode", "normal_smoothing", "normal_sigma", "bilateral_angle",
          "weld_duplicates", "laplace_operator", "gradient_estimator", "curvature_derivatives"})
        for (const auto& row : laplacian_lines::precompute_option_table())
            if (row.key == key) rows.push_back(row);
    return rows;
}

const auto& optionTable() {
    static const auto table = makeTable();
    return table;
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
            "Chooses how the surface is analysed; without this filter, Render &gt; <b>Laplacian "
            "Lines</b> takes the defaults. The result is in per-vertex attributes <b>ll_...</b>, "
            "until the mesh changes.<br>"
            "After Zhang, He and Seah, <i>Laplacian Lines for Real-Time Shape Illustration</i>, "
            "2009. Version ") +
        laplacian_lines::version() + '.';
    result.filter_class =
        meshlab_host::FilterInterface::Normal | meshlab_host::FilterInterface::Quality;
    result.preconditions = MeshModel::MM_FACENUMBER;
    return result;
}

void ComputeFilter::listParameters(const MeshModel* mesh, RichParameterList& list) const {
    meshlab_host::addParameters(optionTable(), PrecomputeOptions(),
                                mesh ? double(mesh->cm.bbox.Diag()) : 0, key_prefix, list);
}

void ComputeFilter::run(const meshlab_host::FilterRun& run) const {
    QElapsedTimer clock;
    clock.start();
    const auto options = meshlab_host::readOptions(optionTable(), key_prefix, run.parameters);
    const CMeshO& mesh = run.document.mm()->cm;
    const int mesh_id = run.document.mm()->id();
    const meshlab_host::GeometryStamp stamp = meshlab_host::geometryStamp(mesh);
    const Field field = laplacian_lines::precompute(meshlab_host::toTriangleMesh(mesh), options,
                                                    meshlab_host::progressTo(run.progress));
    store(run.document, mesh_id, stamp, field, options);
    for (const QString& line : computeReport(field, options, 1e-3 * double(clock.elapsed())))
        run.say(line);
}
