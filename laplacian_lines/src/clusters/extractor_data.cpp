// SPDX-License-Identifier: GPL-3.0-or-later
// What an extractor keeps of a mesh and its field: clusters (cluster_building.cpp), the linear
// forms of Δn, and records of S̄ and C if the field has them, all in local coordinates and within
// limits, so that no product overflows.
#include "clusters/extractor_data.h"

#include <cmath>

#include "clusters/cluster_building.h"
#include "clusters/coarseness.h"
#include "field/derivative_scale.h"
#include "laplacian_lines/field_columns.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr double kPrepared = 0.1;  // about the part of the whole time at which prepare() ends
constexpr double kLargestLaplacian = 1e12, kLargestDerivative = 1e16;  // Δn·D², C·D²
// Of slopes of Laplacian lines: by their own scale alone gentle forms would have none for a kernel
// of a mean edge; by that of derivatives what is finest would have too many.
constexpr double kOwnShare = 0.75;

template <class T>
std::size_t bytes(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

// In D: floats of coordinates beyond are coarser than 1e-6 D.
constexpr double kFar = 16;

/// Where the field was computed across cuts, lines go across them.
PreparedMesh prepare(const TriangleMesh& mesh, const Field& field) {
    if (!has_entries(field, mesh.positions.size())) refuse_field();
    return prepare_geometry(mesh, cuts_of(field.report), facing_of(field.report));
}

std::vector<FormGroup> laplacian_forms(const PreparedMesh& mesh, const Field& field,
                                       const ExtractorData& data) {
    const Cluster* last = data.clusters.empty() ? nullptr : &data.clusters.back();
    auto forms = large_array<FormGroup>(last ? last->first_form_group + form_groups(*last) : 0);
    const double factor = data.diagonal * data.diagonal;
    in_parallel(data.clusters.size(), [&](std::size_t c) {
        const Cluster& cluster = data.clusters[c];
        write_forms(&forms[cluster.first_form_group], cluster, [&](unsigned i) {
            const std::uint32_t v = data.vertices_of_clusters[cluster.first_vertex + i];
            const Eigen::Vector3f& laplacian = field.laplacian_normals[mesh.original_vertex[v]];
            return FormVector{bounded(laplacian, factor, kLargestLaplacian), mesh.positions[v]};
        });
    });
    return forms;
}

std::vector<CurvatureRecord> curvature_records(const PreparedMesh& mesh, const Field& field,
                                               const ExtractorData& data) {
    std::vector<CurvatureRecord> records(data.vertices_of_clusters.size());
    const double d = data.diagonal;
    const std::vector<PlacedCluster> clusters = place_clusters(data);
    in_parallel(clusters.size(), [&](std::size_t c) {
        const Cluster& cluster = *clusters[c].cluster;
        for (unsigned i = 0; i < cluster.vertex_count; ++i) {
            const std::uint32_t v = mesh.original_vertex[clusters[c].vertices[i]];
            CurvatureRecord& record = records[cluster.first_vertex + i];
            const Eigen::Vector3f position = position_of(clusters[c].records[i]),
                                  normal = normal_of(clusters[c].records[i]);
            for (int k = 0; k < 3; ++k) {
                record.position[k] = position[k];
                record.normal[k] = normal[k];
                record.curvature[k] =
                    float(bounded(field.smooth_curvatures[v][k] * d, kLargestCurvature));
            }
            for (int k = 0; k < 4; ++k)
                record.derivative[k] =
                    float(bounded(field.curvature_derivatives[v][k] * d * d, kLargestDerivative));
        }
    });
    return records;
}

}  // namespace

ClusterStore ExtractorData::store() const {
    return {reinterpret_cast<const unsigned char*>(memory_of_clusters.data()),
            clusters.data(),
            border_edges.data(),
            laplacians.data(),
            bounds.data(),
            curvatures.empty() ? nullptr : curvatures.data()};
}

std::size_t ExtractorData::memory() const {
    return sizeof(*this) + bytes(memory_of_clusters) + bytes(clusters) +
           bytes(vertices_of_clusters) + bytes(border_edges) + bytes(bounds) + bytes(curvatures) +
           bytes(laplacians) + horizon.memory();
}

std::vector<PlacedCluster> place_clusters(const ExtractorData& data) {
    std::vector<PlacedCluster> placed;
    placed.reserve(data.clusters.size());
    const ClusterStore store = data.store();
    std::uint32_t triangles = 0;
    for (const Cluster& cluster : data.clusters) {
        placed.push_back(
            {&cluster, triangles, data.vertices_of_clusters.data() + cluster.first_vertex,
             triangles_of(store, cluster),
             reinterpret_cast<const VertexRecord*>(memory_of(store, cluster) +
                                                   cluster_layout(cluster).records),
             data.laplacians.data() + cluster.first_form_group,
             data.curvatures.empty() ? nullptr : data.curvatures.data() + cluster.first_vertex});
        triangles += cluster.triangle_count;
    }
    return placed;
}

bool can_extract(LineKind kind, const ExtractorData& data) {
    return !describe(kind).needs_derivatives || !data.curvatures.empty();
}

void add_derivatives(const TriangleMesh& mesh, const Field& field, ExtractorData& data) {
    const PreparedMesh prepared = prepare(mesh, field);
    if (!field.has_derivatives() || prepared.size() != data.vertex_count) refuse_field();
    data.curvatures = curvature_records(prepared, field, data);
}

ExtractorData build_extractor_data(const TriangleMesh& mesh, const Field& field,
                                   const Progress& progress) {
    const StageProgress stage(progress, 0, 1, "Preparing the extraction of lines");
    stage.report(0);
    const PreparedMesh prepared = prepare(mesh, field);
    ExtractorData data;
    data.centre = prepared.centre;
    data.diagonal = prepared.diagonal;
    if (data.centre.cwiseAbs().maxCoeff() > kFar * data.diagonal) data.origin = data.centre;
    data.is_rough = is_rough(field.report);
    data.kernel_size = float(field.scale.kernel_size / field.scale.diagonal);
    data.squared_scale = squared_scale(derivative_kernel(field.scale), field.scale);
    const double own = squared_scale(field.scale.kernel_size, field.scale);
    data.laplacian_squared_scale =
        std::pow(own, kOwnShare) * std::pow(data.squared_scale, 1 - kOwnShare);
    build_clusters(prepared, field, stage.part(kPrepared, 1), data);
    data.laplacians = laplacian_forms(prepared, field, data);
    if (field.has_derivatives()) data.curvatures = curvature_records(prepared, field, data);
    return data;
}

}  // namespace laplacian_lines
