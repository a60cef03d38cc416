// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/edge_horizon.h"

namespace laplacian_lines {
namespace {

constexpr double kLeastHollow = 0.02;  // sine of 1.1°: what is flatter hides no contour

Eigen::Vector3d centre_of(const PreparedMesh& mesh, const Triangle& t) {
    return (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
}

Eigen::Vector3d normal_of(const PreparedMesh& mesh, const Triangle& t) {
    return area_vector(mesh, t).stableNormalized();
}

/// Whether the surface is concave between two triangles.
bool is_hollow(const PreparedMesh& mesh, const Triangle& a, const Triangle& b) {
    const Eigen::Vector3d between = centre_of(mesh, b) - centre_of(mesh, a);
    return normal_of(mesh, a).dot(between) > kLeastHollow * between.norm();
}

void append_plane(const PreparedMesh& mesh, const Triangle& t, EdgeHorizon& horizon) {
    const Eigen::Vector3d normal = normal_of(mesh, t);
    for (int k = 0; k < 3; ++k)
        horizon.planes[k].push_back(float(normal[k]));
    horizon.planes[3].push_back(float(normal.dot(mesh.positions[t[0]])));
}

}  // namespace

void EdgeHorizon::evaluate(const Eigen::Vector3f& eye, float w, std::vector<float>& facing) const {
    const auto& [x, y, z, offset] = planes;
    const float ex = eye.x(), ey = eye.y(), ez = eye.z();
    facing.resize(offset.size());
    for (std::size_t i = 0; i < facing.size(); ++i)
        facing[i] = x[i] * ex + y[i] * ey + z[i] * ez - w * offset[i];
}

std::size_t EdgeHorizon::memory() const {
    return edges.capacity() * sizeof(Edge) + positions.capacity() * sizeof(Eigen::Vector3f) +
           4 * planes[0].capacity() * sizeof(float);
}

EdgeHorizon find_edge_horizon(const PreparedMesh& mesh, const CornerTable& sides, bool is_body) {
    EdgeHorizon horizon;
    for (const Eigen::Vector3d& p : mesh.positions)
        horizon.positions.push_back(p.cast<float>());
    for (const Triangle& t : mesh.triangles)
        append_plane(mesh, t, horizon);
    for (std::uint32_t side = 0; side < sides.side_count(); ++side) {
        const std::uint32_t across = sides.across(side), from = begin_of(mesh.triangles, side);
        if (!sides.has_neighbour(side) || across < side) continue;
        const std::uint32_t a = side / 3, b = across / 3;
        const bool is_reversed = !have_one_orientation(mesh.triangles, side, across);
        const bool hides =
            is_body && !is_reversed && is_hollow(mesh, mesh.triangles[a], mesh.triangles[b]);
        horizon.edges.push_back({{from, end_of(mesh.triangles, side)}, {a, b}, is_reversed, hides});
    }
    return horizon;
}

}  // namespace laplacian_lines
