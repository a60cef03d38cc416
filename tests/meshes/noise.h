// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

/// Each vertex moved by `share` mean edges in a random direction, the same ones for the same seed.
laplacian_lines::TriangleMesh with_noise(const laplacian_lines::TriangleMesh& mesh, double share,
                                         unsigned seed = 1);

}  // namespace test_meshes
