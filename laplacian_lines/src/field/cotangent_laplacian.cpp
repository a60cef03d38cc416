// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/field_steps.h"

namespace laplacian_lines {

std::vector<Eigen::Vector3d> cotangent_laplacian(const PreparedMesh& mesh,
                                                 const std::vector<Eigen::Vector3d>& normals) {
    std::vector<Eigen::Vector3d> laplacian(mesh.size(), Eigen::Vector3d::Zero());
    for (const Triangle& t : mesh.triangles) {
        const double twice_area = area_vector(mesh, t).norm();
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];
            const Eigen::Vector3d& opposite = mesh.positions[t[k]];
            const double cotangent =
                (mesh.positions[a] - opposite).dot(mesh.positions[b] - opposite) / twice_area;
            const Eigen::Vector3d flow = cotangent / 2 * (normals[b] - normals[a]);
            laplacian[a] += flow;
            laplacian[b] -= flow;
        }
    }
    for (std::size_t i = 0; i < laplacian.size(); ++i)
        laplacian[i] /= mesh.masses[i];
    return laplacian;
}

}  // namespace laplacian_lines
