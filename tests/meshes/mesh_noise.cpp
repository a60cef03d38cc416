// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_noise.h"

#include "laplacian_lines/precompute.h"

namespace mesh_noise {
namespace {

/// Uniform: points of the cube outside the ball are drawn again.
Eigen::Vector3d random_direction(std::mt19937& random) {
    while (true) {
        const double x = signed_unit(random), y = signed_unit(random), z = signed_unit(random);
        const Eigen::Vector3d p(x, y, z);
        if (p.norm() <= 1 && p.norm() > 0.01) return p.normalized();
    }
}

}  // namespace

laplacian_lines::TriangleMesh with_noise(const laplacian_lines::TriangleMesh& mesh, double share,
                                         unsigned seed) {
    laplacian_lines::TriangleMesh noisy = mesh;
    const double length = share * laplacian_lines::measure_scale(mesh).mean_edge;
    std::mt19937 random(seed);
    for (Eigen::Vector3d& p : noisy.positions)
        p += length * random_direction(random);
    return noisy;
}

}  // namespace mesh_noise
