// SPDX-License-Identifier: GPL-3.0-or-later
#include "whole_mesh.h"

namespace laplacian_lines {
namespace {

/// The vector of place v of linear forms.
Eigen::Vector3f read_form(const unsigned char* forms, unsigned v) {
    const float* form =
        reinterpret_cast<const float*>(forms) + v / kFormGroup * 4 * kFormGroup + v % kFormGroup;
    return {form[0], form[kFormGroup], form[2 * kFormGroup]};
}

WholeMesh::Vertex read_vertex(const unsigned char* memory, const ClusterLayout& layout,
                              unsigned v) {
    const auto& record = reinterpret_cast<const VertexRecord*>(memory + layout.records)[v];
    const auto& s = record.shape_operator;
    return {Eigen::Vector3f(record.position[0], record.position[1], record.position[2]),
            read_form(memory, v),
            read_form(memory + layout.laplacians, v),
            {s[0][0], s[1][1], s[2][2], s[2][1], s[2][0], s[1][0]},
            record.slope_scale};
}

}  // namespace

WholeMesh rebuild_mesh(const ExtractorData& data) {
    WholeMesh mesh;
    mesh.vertices.resize(data.vertex_count);
    const ClusterStore store = data.store();
    const std::uint32_t* vertices = data.vertices_of_clusters.data();
    for (const Cluster& cluster : data.clusters) {
        const unsigned char* memory = memory_of(store, cluster);
        const ClusterLayout layout = cluster_layout(cluster);
        for (unsigned v = 0; v < cluster.vertex_count; ++v)
            mesh.vertices[vertices[v]] = read_vertex(memory, layout, v);
        const auto* triangles = reinterpret_cast<const ClusterTriangle*>(memory + layout.triangles);
        for (unsigned t = 0; t < cluster.triangle_count; ++t) {
            const auto& corners = triangles[t].corners;
            mesh.triangles.push_back(
                {vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]});
        }
        vertices += cluster.vertex_count;
    }
    mesh.topology = build_edge_topology(mesh.vertices.size(), mesh.triangles);
    return mesh;
}

}  // namespace laplacian_lines
