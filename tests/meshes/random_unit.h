// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh_noise.h"

namespace test_meshes {

using mesh_noise::signed_unit;

inline double between(std::mt19937& random, double least, double most) {
    return least + (most - least) * (signed_unit(random) + 1) / 2;
}

}  // namespace test_meshes
