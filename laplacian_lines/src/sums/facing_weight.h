// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace laplacian_lines {

/// Weight by the cosine between two normals ("Skip Opposite Sheet"): 1 for equal ones, 1/2 at a
/// right angle, 0 for opposite ones, flat at both ends, so that smooth surfaces keep their Δn up to
/// second order in h|A|². A polynomial, so that it can be summed over a grid as moments of the
/// normals.
template <class Real>
inline __attribute__((always_inline)) Real facing_weight(Real cosine) {
    return (1 + cosine) * (1 + cosine) * (2 - cosine) / 4;
}

}  // namespace laplacian_lines
