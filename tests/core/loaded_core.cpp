// SPDX-License-Identifier: GPL-3.0-or-later
// The core as in a plugin, for unload_core.
#include "generators.h"
#include "laplacian_lines/precompute.h"

extern "C" std::size_t count_normals() {
    return laplacian_lines::precompute(test_meshes::torus(80, 40).mesh).normals.size();
}
