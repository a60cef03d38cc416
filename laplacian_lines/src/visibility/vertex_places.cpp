// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/vertex_places.h"

namespace laplacian_lines {

using Eigen::Vector3d;

Eigen::AlignedBox3f box_around(const Vector3d& a, const Vector3d& b, double reach) {
    Eigen::AlignedBox3f box(a.cwiseMin(b).cast<float>());
    box.extend(a.cwiseMax(b).cast<float>().eval());
    // floats round by less than 1e-7 here
    const Eigen::Vector3f more = Eigen::Vector3f::Constant(float(reach) + 1e-7f);
    return {box.min() - more, box.max() + more};
}

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
    const auto point = [&](std::uint32_t v) -> Eigen::Vector3f {
        return mesh.positions[v].cast<float>();
    };
    vertices_ = order_along_curve<3>(vertices.size(), local_box(),
                                     [&](std::uint32_t i) { return point(vertices[i]); });
    for (std::uint32_t& i : vertices_)
        i = vertices[i];
    tree_ = {vertices_, [&](std::uint32_t v) { return Eigen::AlignedBox3f(point(v)); }};
}

}  // namespace laplacian_lines
