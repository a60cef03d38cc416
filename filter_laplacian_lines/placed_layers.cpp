// SPDX-License-Identifier: GPL-3.0-or-later
#include "placed_layers.h"

#include <Eigen/LU>
#include <QStringList>
#include <cmath>
#include <utility>

#include "laplacian_lines/error.h"
#include "laplacian_lines/precompute.h"
#include "meshlab_host/camera.h"
#include "meshlab_host/documents.h"
#include "meshlab_host/field_source.h"
#include "meshlab_host/mesh_conversion.h"

using laplacian_lines::Error;
using laplacian_lines::ErrorCode;
using laplacian_lines::Field;
using laplacian_lines::Progress;
using laplacian_lines::ShapeOperator;
using meshlab_host::FilterRun;
using meshlab_host::Similarity;

namespace {

Eigen::Matrix3f matrixOf(const ShapeOperator& s) {
    Eigen::Matrix3f matrix;
    matrix << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
    return matrix;
}

ShapeOperator shapeOperatorOf(const Eigen::Matrix3f& m) {
    return {m(0, 0), m(1, 1), m(2, 2), m(1, 2), m(0, 2), m(0, 1)};
}

/// A stretched layer needs a field of its own.
laplacian_lines::Field fieldOfStretched(const laplacian_lines::TriangleMesh& mesh, double factor,
                                        laplacian_lines::PrecomputeOptions options,
                                        const FilterRun& run, const Progress& progress) {
    run.say("The layer's transformation stretches it: its lines are recomputed as it stands.");
    options.kernel_size *= factor;
    return laplacian_lines::precompute(mesh, options, progress);
}

PlacedLayer placeInWorld(const MeshModel& layer, const FilterRun& run, const Progress& progress) {
    const Eigen::Matrix4d transform = meshlab_host::layerTransform(layer.cm);
    const std::optional<Similarity> similarity = meshlab_host::similarityOf(transform);
    const meshlab_host::FieldSource source = meshlab_host::fieldSource(layer.cm);
    PlacedLayer result{layer.label(), meshlab_host::toTriangleMesh(layer.cm), {}};
    if (source.status != meshlab_host::FieldStatus::Current) {
        place(transform, result.mesh);
        laplacian_lines::measure_scale(result.mesh, {});  // refuses what cannot be drawn
        return result;
    }
    if (!similarity) {
        place(transform, result.mesh);
        result.field = fieldOfStretched(result.mesh, meshlab_host::meanScale(transform),
                                        source.options, run, progress);
        return result;
    }
    result.field =
        meshlab_host::demandField(layer.cm, result.mesh, result.name, source, run.say, progress);
    if (transform.isIdentity(0)) return result;
    place(transform, result.mesh);
    place(*similarity, *result.field);
    return result;
}

void placeAllVisible(const FilterRun& run, double share, PlacedLayers& placed) {
    const std::vector<int> ids = meshlab_host::layerIds(run.document, true);
    const double step = share / std::max<double>(1, double(ids.size()));
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const MeshModel* layer = run.document.getMesh(ids[i]);  // may have gone meanwhile
        if (!layer) continue;
        const QString name = layer->label();
        if (layer->cm.fn == 0) {
            run.say(QString("%1 is left out of the drawing: it has no faces.").arg(name));
            continue;
        }
        const double begin = step * double(i);
        try {
            placed.push_back(placeInWorld(
                *layer, run, meshlab_host::progressTo(run.progress, begin, begin + step)));
        } catch (const Error& error) {
            if (error.code() == ErrorCode::Cancelled) throw;
            run.say(QString("%1 is left out of the drawing: %2").arg(name, error.what()));
        }
    }
    if (placed.empty())
        laplacian_lines::refuse(
            "No visible layer can be drawn. Show one that has faces, or set \"Layers\" to "
            "0 (Current Layer).");
}

}  // namespace

void place(const Eigen::Matrix4d& layer, laplacian_lines::TriangleMesh& mesh) {
    const Eigen::Matrix3d linear = layer.topLeftCorner<3, 3>();
    const double determinant = linear.determinant();
    if (determinant == 0 || !layer.allFinite())
        laplacian_lines::refuse(
            "The layer's transformation cannot be inverted. Reset it, or freeze it.");
    for (Eigen::Vector3d& p : mesh.positions)
        p = linear * p + layer.topRightCorner<3, 1>();
    if (determinant < 0)
        for (laplacian_lines::Triangle& triangle : mesh.triangles)
            std::swap(triangle[1], triangle[2]);
}

void place(const Similarity& similarity, Field& field) {
    const Eigen::Matrix3f rotation = similarity.rotation.cast<float>();
    const auto factor = float(similarity.factor);
    for (Eigen::Vector3f& n : field.normals)
        n = (rotation * n).eval();
    for (Eigen::Vector3f& n : field.laplacian_normals)
        n = (rotation * n / (factor * factor)).eval();
    for (ShapeOperator& s : field.shape_operators)
        s = shapeOperatorOf(rotation * matrixOf(s) * rotation.transpose() / factor);
    field.smooth_curvatures.clear();
    field.curvature_derivatives.clear();
    for (float& size : field.kernel_sizes)
        size *= factor;
    for (double* length : {&field.scale.diagonal, &field.scale.mean_edge, &field.scale.kernel_size,
                           &field.scale.normal_sigma})
        *length *= similarity.factor;
}

PlacedLayers placeLayers(const LayerChoice& choice, const FilterRun& run, double share) {
    constexpr double field_part = 0.9;
    PlacedLayers placed;
    if (choice.all_visible)
        placeAllVisible(run, field_part * share, placed);
    else
        placed.push_back(
            placeInWorld(*run.document.mm(), run,
                         meshlab_host::progressTo(run.progress, 0, field_part * share)));
    if (!choice.derivatives) return placed;
    double begin = field_part * share;
    const double step = (share - begin) / double(placed.size());
    for (PlacedLayer& layer : placed) {
        if (layer.field)
            meshlab_host::demandDerivatives(
                layer.mesh, *layer.field,
                meshlab_host::progressTo(run.progress, begin, begin + step));
        begin += step;
    }
    return placed;
}

line_drawing::Objects objectsOf(const PlacedLayers& layers) {
    line_drawing::Objects objects;
    for (const PlacedLayer& layer : layers)
        objects.push_back(
            {layer.mesh, layer.field ? &*layer.field : nullptr, layer.name.toStdString()});
    return objects;
}

QString namesOf(const PlacedLayers& layers) {
    QStringList names;
    for (const PlacedLayer& layer : layers)
        names << layer.name;
    return names.join(", ");
}
