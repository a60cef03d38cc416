// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/vertex_places.h"

namespace laplacian_lines {

std::vector<bool> vertices_of_edges(const SightMesh& mesh) {
    std::vector<bool> are_used(mesh.positions.size());
    for (std::size_t e = 0; e < mesh.edge_count(); ++e)
        for (const std::uint32_t v : mesh.edges[e].vertices)
            are_used[v] = true;
    return are_used;
}

VertexPlaces::VertexPlaces(const SightMesh& mesh, const std::vector<bool>& wanted)
    : step_(1 / std::sqrt(double(mesh.positions.size()))) {
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
        if (wanted[v]) vertices.push_back(v);
    tree_ = BoxTree<3>::along_curve(std::move(vertices), local_box(), [&](std::uint32_t v) {
        return Eigen::AlignedBox3f(mesh.positions[v].cast<float>().eval());
    });
}

}  // namespace laplacian_lines
