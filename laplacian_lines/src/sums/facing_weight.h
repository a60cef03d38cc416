// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace laplacian_lines {

/// How much a vertex counts for another, by the cosine between their normals: 1 for equal normals,
/// 1/2 at a right angle, 0 for opposite ones, without slope at both ends ("Skip Opposite Sheet").
/// A polynomial of the normals' products, so that it can be summed over a grid as moments of the
/// normals; without a slope at 1, smooth surfaces keep their Δn up to second order in h|A|².
template <class Real>
inline __attribute__((always_inline)) Real facing_weight(Real cosine) {
    return (1 + cosine) * (1 + cosine) * (2 - cosine) / 4;
}

}  // namespace laplacian_lines
