// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/extractor_data.h"

#include <algorithm>
#include <cstdlib>
#include <new>
#ifdef __linux__
#include <sys/mman.h>
#endif

#include "clusters/cluster_building.h"
#include "clusters/coarseness.h"
#include "clusters/curvature_records.h"
#include "field/tensor_fits.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/field_columns.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {
namespace {

constexpr double kPrepared = 0.1;            // about the part of the whole time that it takes
constexpr std::size_t kHugePage = 2u << 20;  // bytes; clusters are read in no order of addresses

template <class T>
std::size_t bytes(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

// In D: floats of coordinates beyond are coarser than 1e-6 D.
constexpr double kFar = 16;

[[noreturn]] void refuse_field() {
    throw Error(ErrorCode::FieldMismatch,
                "The Laplacian lines field belongs to another mesh; compute it again.");
}

PreparedMesh prepare(const TriangleMesh& mesh, const Field& field, int undone) {
    if (!has_entries(field, mesh.positions.size())) refuse_field();
    // Where the field was computed across cuts, lines go across them.
    return prepare_geometry(mesh, field.report.welded_vertices > 0 ? Cuts::Stitched : Cuts::Left,
                            {undone},
                            field.report.turned_triangles > 0 ? Facing::Outwards : Facing::Kept);
}

}  // namespace

void ExtractorData::Free::operator()(unsigned char* memory) const {
    std::free(memory);
}

void ExtractorData::allocate(std::size_t bytes) {
    const std::size_t alignment = bytes < kHugePage ? kCacheUnit : kHugePage;
    void* memory;
    if (posix_memalign(&memory, alignment, bytes) != 0) throw std::bad_alloc();
    memory_of_clusters.reset(static_cast<unsigned char*>(memory));
#ifdef __linux__
    madvise(memory, bytes, MADV_HUGEPAGE);  // no harm if it fails
#endif
    bytes_of_clusters = bytes;
    bounds.assign(FacingBounds::kNumbers * padded_cluster_count(), 0);
}

std::size_t ExtractorData::padded_cluster_count() const {
    return (clusters.size() + kFormGroup - 1) / kFormGroup * kFormGroup;
}

ClusterStore ExtractorData::store(const LaplacianForms& forms) const {
    const auto array = [&](std::size_t i) { return bounds.data() + i * padded_cluster_count(); };
    return {memory_of_clusters.get(),
            clusters.data(),
            border_edges.data(),
            forms.groups.data(),
            {{array(0), array(1), array(2)},
             {array(3), array(4), array(5)},
             {{array(6), array(7), array(8)},
              {array(9), array(10), array(11)},
              {array(12), array(13), array(14)}},
             array(15),
             array(16)},
            curvatures.empty() ? nullptr : curvatures.data()};
}

std::size_t ExtractorData::memory() const {
    return sizeof(*this) + bytes_of_clusters + bytes(clusters) + bytes(vertices_of_clusters) +
           bytes(border_edges) + bytes(bounds) + bytes(curvatures) + laplacians.memory();
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
             data.laplacians.groups.data() + cluster.first_form_group,
             data.curvatures.empty() ? nullptr : data.curvatures.data() + cluster.first_vertex});
        triangles += cluster.triangle_count;
    }
    return placed;
}

bool has_needs_of(LineKind kind, const ExtractorData& data) {
    return !describe(kind).needs_derivatives || !data.curvatures.empty();
}

LaplacianForms build_laplacian_forms(const TriangleMesh& mesh, const Field& field,
                                     const ExtractorData& data) {
    const PreparedMesh prepared = prepare(mesh, field, data.undone_subdivisions);
    if (prepared.size() != data.vertex_count) refuse_field();
    return laplacian_forms(prepared, field, data);
}

void add_derivatives(const TriangleMesh& mesh, const Field& field, ExtractorData& data) {
    const PreparedMesh prepared = prepare(mesh, field, data.undone_subdivisions);
    if (!field.has_derivatives() || prepared.size() != data.vertex_count) refuse_field();
    data.curvatures = curvature_records(prepared, field, data);
}

ExtractorData build_extractor_data(const TriangleMesh& mesh, const Field& field,
                                   const Progress& progress) {
    const StageProgress stage(progress, 0, 1, "Preparing the extraction of lines");
    stage.report(0);
    const PreparedMesh prepared = prepare(mesh, field, field.report.undone_subdivisions);
    ExtractorData data;
    data.undone_subdivisions = prepared.report.undone_subdivisions;
    data.centre = prepared.centre;
    data.diagonal = prepared.diagonal;
    if (data.centre.cwiseAbs().maxCoeff() > kFar * data.diagonal) data.origin = data.centre;
    data.is_rough = is_rough(field.report);
    data.squared_scale = squared_scale(derivative_kernel(field.scale), field.scale);
    ClusterBuilder(prepared, field, data).build(stage.part(kPrepared, 1));
    data.laplacians = laplacian_forms(prepared, field, data);
    if (field.has_derivatives()) data.curvatures = curvature_records(prepared, field, data);
    return data;
}

}  // namespace laplacian_lines
