// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/vertex_places.h"

namespace laplacian_lines {

using Eigen::Vector3d;

BoxLevels<3>::Box box_around(const Vector3d& a, const Vector3d& b, double reach) {
    BoxLevels<3>::Box box(a.cwiseMin(b).cast<float>());
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

bool lies_between(const SightMesh& mesh, std::uint32_t vertex, std::uint32_t from, std::uint32_t to,
                  double within) {
    if (vertex == from || vertex == to) return false;
    const Vector3d way = mesh.positions[to] - mesh.positions[from],
                   aside = mesh.positions[vertex] - mesh.positions[from];
    const double product = way.dot(aside), square = way.squaredNorm();
    if (!(product > 0 && product < square)) return false;  // most, without a root
    const double length = std::sqrt(square), along = product / length;
    return along > within && along < length - within &&
           (aside - along / length * way).norm() <= within;
}

VertexPlaces::VertexPlaces(const SightMesh& mesh, const std::vector<bool>& wanted)
    : step_(1 / std::sqrt(double(mesh.positions.size()))),
      levels_(mesh.positions.size(), [&](std::uint32_t v) {
          // as large as the way to the next vertex, so that a query has few cells
          const Vector3d& p = mesh.positions[v];
          return wanted[v] ? box_around(p, p, step_ / 2) : BoxLevels<3>::Box();
      }) {}

}  // namespace laplacian_lines
