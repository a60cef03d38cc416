// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

namespace test_meshes {

/// −1..1; the standard's distributions differ between libraries, its engines do not.
inline double signed_unit(std::mt19937& random) {
    return double(random()) / double(std::mt19937::max()) * 2 - 1;
}
/// Between the two.
inline double between(std::mt19937& random, double least, double most) {
    return least + (most - least) * (signed_unit(random) + 1) / 2;
}

}  // namespace test_meshes
