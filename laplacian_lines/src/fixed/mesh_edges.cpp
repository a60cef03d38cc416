// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/mesh_edges.h"

#include <Eigen/Geometry>

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kMany = MeshEdges::kNone - 1;  // stands for three triangles or more

void add_triangle(MeshEdges::Edge& edge, std::uint32_t triangle) {
    auto& [first, second] = edge.triangles;
    if (first == MeshEdges::kNone)
        first = triangle;
    else
        second = second == MeshEdges::kNone ? triangle : kMany;
}

}  // namespace

MeshEdges find_mesh_edges(const WholeMesh& whole) {
    MeshEdges mesh;
    mesh.positions = whole.positions;
    mesh.edges.assign(whole.topology.edge_count, {{}, {MeshEdges::kNone, MeshEdges::kNone}});
    mesh.planes.resize(whole.triangles.size());
    for (std::uint32_t i = 0; i < whole.triangles.size(); ++i) {
        const Triangle& t = whole.triangles[i];
        const auto corner = [&](std::size_t k) -> Eigen::Vector3d {
            return whole.positions[t[k]].cast<double>();
        };
        const Eigen::Vector3d area = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        mesh.planes.set(i, area.stableNormalized(), corner(0));
        for (std::size_t k = 0; k < 3; ++k) {
            MeshEdges::Edge& edge = mesh.edges[whole.topology.edges_of_triangle[i][k]];
            edge.vertices = {t[(k + 1) % 3], t[(k + 2) % 3]};
            add_triangle(edge, i);
        }
    }
    for (MeshEdges::Edge& edge : mesh.edges)
        if (edge.triangles[1] == kMany) edge.triangles[1] = MeshEdges::kNone;
    return mesh;
}

}  // namespace laplacian_lines
