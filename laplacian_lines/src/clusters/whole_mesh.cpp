// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/whole_mesh.h"

namespace laplacian_lines {
WholeMesh rebuild_mesh(const ExtractorData& data) {
    WholeMesh mesh;
    mesh.positions.resize(data.vertex_count);
    for (const PlacedCluster& placed : place_clusters(data)) {
        const std::uint32_t* vertices = placed.vertices;
        for (unsigned v = 0; v < placed.cluster->vertex_count; ++v)
            mesh.positions[vertices[v]] =
                Eigen::Map<const Eigen::Vector3f>(placed.records[v].position);
        for (unsigned t = 0; t < placed.cluster->triangle_count; ++t) {
            const auto& corners = placed.triangles[t].corners;
            mesh.triangles.push_back(
                {vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]});
        }
    }
    mesh.topology = build_edge_topology(mesh.positions.size(), mesh.triangles);
    return mesh;
}

}  // namespace laplacian_lines
