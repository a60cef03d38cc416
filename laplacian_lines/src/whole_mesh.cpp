// SPDX-License-Identifier: GPL-3.0-or-later
#include "whole_mesh.h"

namespace laplacian_lines {
WholeMesh rebuild_mesh(const ExtractorData& data) {
    WholeMesh mesh;
    mesh.positions.resize(data.vertex_count);
    const ClusterStore store = data.store();
    const std::uint32_t* vertices = data.vertices_of_clusters.data();
    for (const Cluster& cluster : data.clusters) {
        const unsigned char* memory = memory_of(store, cluster);
        const ClusterLayout layout = cluster_layout(cluster);
        const auto* records = reinterpret_cast<const VertexRecord*>(memory + layout.records);
        for (unsigned v = 0; v < cluster.vertex_count; ++v)
            mesh.positions[vertices[v]] = Eigen::Map<const Eigen::Vector3f>(records[v].position);
        const auto* triangles = reinterpret_cast<const ClusterTriangle*>(memory + layout.triangles);
        for (unsigned t = 0; t < cluster.triangle_count; ++t) {
            const auto& corners = triangles[t].corners;
            mesh.triangles.push_back(
                {vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]});
        }
        vertices += cluster.vertex_count;
    }
    mesh.topology = build_edge_topology(mesh.positions.size(), mesh.triangles);
    return mesh;
}

}  // namespace laplacian_lines
