// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/mesh_conversion.h"

#include "laplacian_lines/refinement.h"

namespace meshlab_host {

bool has_deleted_vertices(const CMeshO& mesh) {
    return mesh.vert.size() != std::size_t(mesh.vn);
}

std::vector<std::uint32_t> live_vertex_indices(const CMeshO& mesh) {
    std::vector<std::uint32_t> indices(mesh.vert.size(), kNoIndex);
    std::uint32_t next = 0;
    for (std::size_t slot = 0; slot < mesh.vert.size(); ++slot)
        if (!mesh.vert[slot].IsD()) indices[slot] = next++;
    return indices;
}

laplacian_lines::TriangleMesh to_triangle_mesh(const CMeshO& mesh) {
    laplacian_lines::TriangleMesh result;
    result.positions.reserve(mesh.vert.size());
    for (const CVertexO& vertex : mesh.vert)
        if (!vertex.IsD())
            result.positions.emplace_back(vertex.cP()[0], vertex.cP()[1], vertex.cP()[2]);

    const std::vector<std::uint32_t> indices = live_vertex_indices(mesh);
    result.triangles.reserve(mesh.face.size());
    for (const CFaceO& face : mesh.face) {
        if (face.IsD()) continue;
        laplacian_lines::Triangle triangle;
        for (int corner = 0; corner < 3; ++corner)
            triangle[corner] = indices[vcg::tri::Index(mesh, face.cV(corner))];
        result.triangles.push_back(triangle);
    }
    return result;
}

laplacian_lines::TriangleMesh to_drawn_mesh(const CMeshO& mesh) {
    return laplacian_lines::refined(to_triangle_mesh(mesh));
}

}  // namespace meshlab_host
