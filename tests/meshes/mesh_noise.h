// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "laplacian_lines/triangle_mesh.h"

namespace mesh_noise {

/// −1..1. The standard's distributions, unlike its engines, differ between libraries.
inline double signed_unit(std::mt19937& random) {
    return double(random()) / double(std::mt19937::max()) * 2 - 1;
}

/// Each vertex moved by `share` mean edges in a random direction, determined by the seed.
laplacian_lines::TriangleMesh with_noise(const laplacian_lines::TriangleMesh& mesh, double share,
                                         unsigned seed = 1);

}  // namespace mesh_noise
