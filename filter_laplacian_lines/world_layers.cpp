// SPDX-License-Identifier: GPL-3.0-or-later
#include "world_layers.h"

#include <QStringList>

#include "laplacian_lines/error.h"
#include "laplacian_lines/precompute.h"
#include "meshlab_host/documents.h"
#include "meshlab_host/field_source.h"
#include "meshlab_host/mesh_conversion.h"
#include "meshlab_host/mesh_transform.h"

using laplacian_lines::Error;
using laplacian_lines::ErrorCode;
using laplacian_lines::part;
using laplacian_lines::Progress;
using meshlab_host::FilterRun;

namespace {

constexpr double kFieldShare = 0.9;  // of the time, about; derivatives take the rest

WorldLayer copy_layer(const MeshModel& layer, const FilterRun& run, const Progress& progress) {
    const Eigen::Matrix4d transform = meshlab_host::layer_transform(layer.cm);
    const meshlab_host::FieldSource source = meshlab_host::field_source(layer.cm);
    WorldLayer result{layer.label(), meshlab_host::to_drawn_mesh(layer.cm), {}};
    const bool has_field = source.status == meshlab_host::FieldStatus::Current;
    const bool is_anew = has_field && !meshlab_host::similarity_of(transform);
    if (is_anew)
        result.field.emplace();  // a place for what apply_transform() computes
    else if (has_field)
        result.field = meshlab_host::find_or_compute_field(layer.cm, result.mesh, result.name,
                                                           source, run.say, progress);
    meshlab_host::apply_transform(transform, source.options, result.mesh, result.field, progress);
    if (is_anew)
        run.say(QString("%1 is stretched or mirrored by its transformation: its lines were "
                        "computed anew for the shape that results.")
                    .arg(result.name));
    // refuses now, for this layer alone, what the drawing would refuse as a whole
    if (!result.field) laplacian_lines::measure_scale(result.mesh);
    return result;
}

WorldLayers copy_visible_layers(const FilterRun& run, double share) {
    WorldLayers placed;
    const std::vector<int> ids = meshlab_host::layer_ids(run.document, true);
    const double step = share / double(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const MeshModel* layer = run.document.getMesh(ids[i]);  // may have gone meanwhile
        if (!layer) continue;
        const QString name = layer->label();  // for messages when the layer may be gone
        if (layer->cm.fn == 0) {
            run.say(QString("%1 is left out of the drawing: it has no faces.").arg(name));
            continue;
        }
        const double begin = step * double(i);
        try {
            placed.push_back(copy_layer(*layer, run, part(run.progress, begin, begin + step)));
        } catch (const Error& error) {
            if (error.code() == ErrorCode::Cancelled) throw;
            run.say(QString("%1 is left out of the drawing: %2")
                        .arg(name, QString::fromUtf8(error.what())));
        }
    }
    if (placed.empty())
        laplacian_lines::refuse(
            "No visible layer can be drawn. Show one that has faces, or set \"Layers\" to "
            "0 (Current Layer).");
    return placed;
}

}  // namespace

WorldLayers copy_layers(const LayerChoice& choice, const FilterRun& run, double share) {
    const double fields = choice.derivatives ? kFieldShare * share : share;
    WorldLayers placed;
    if (choice.all_visible)
        placed = copy_visible_layers(run, fields);
    else
        placed.push_back(copy_layer(*run.document.mm(), run, part(run.progress, 0, fields)));
    if (!choice.derivatives) return placed;
    const double step = (share - fields) / double(placed.size());
    double begin = fields;
    for (WorldLayer& layer : placed) {
        if (layer.field)
            meshlab_host::ensure_derivatives(layer.mesh, *layer.field,
                                             part(run.progress, begin, begin + step));
        begin += step;
    }
    return placed;
}

line_drawing::Objects objects_of(const WorldLayers& layers) {
    line_drawing::Objects objects;
    for (const WorldLayer& layer : layers)
        objects.push_back(
            {layer.mesh, layer.field ? &*layer.field : nullptr, layer.name.toStdString()});
    return objects;
}

QString names_of(const WorldLayers& layers) {
    QStringList names;
    for (const WorldLayer& layer : layers)
        names << layer.name;
    return names.join(", ");
}
