// SPDX-License-Identifier: GPL-3.0-or-later
// The loops of the grid, see gaussian_grid.cpp: masses are spread to nodes by cubic B-splines,
// convolved along one axis at a time, and interpolated at points by quartic B-splines. Weights of a
// point are products of one for each axis.
#include "sums/simd_grid.h"

#include "system/simd_sets.h"
#include "system/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_SET {

constexpr int kFirst = kMoments / int(kLanes), kCount = 2 * kFirst;  // vectors of a node

static inline Floats& get(float* moments, int i) {
    return reinterpret_cast<Floats*>(moments)[i];
}
static inline const Floats& get(const float* moments, int i) {
    return reinterpret_cast<const Floats*>(moments)[i];
}

typedef double Places __attribute__((vector_size(32)));  // along x, y, z

/// Cubic B-splines at 0 <= t < 1 from the second of four nodes.
static inline void cubic_spline(Places t, Places weights[4]) {
    const Places s = 1. - t;
    weights[0] = s * s * s * (1 / 6.);
    weights[1] = (t * t * (3. * t - 6.) + 4.) * (1 / 6.);
    weights[2] = (s * s * (3. * s - 6.) + 4.) * (1 / 6.);
    weights[3] = t * t * t * (1 / 6.);
}

/// Quartic B-splines and their derivatives at the same point, on five nodes half way between those
/// of the cubic ones, the first half a cell before theirs; by the recursions of C. de Boor, "A
/// Practical Guide to Splines", chapters IX and X.
static inline void quartic_spline(Places t, const Places cubic[4], Places weights[5],
                                  Places derivatives[5]) {
    for (int k = 0; k < 5; ++k) {
        const Places x = t - (k - 1.5);  // from node k
        const Places left = k > 0 ? cubic[k - 1] : Places{}, right = k < 4 ? cubic[k] : Places{};
        weights[k] = ((2.5 + x) * left + (2.5 - x) * right) * 0.25;
        derivatives[k] = left - right;
    }
}

static inline void to_floats(const Places* values, int count, Float4* floats) {
    for (int k = 0; k < count; ++k)
        floats[k] = __builtin_convertvector(values[k], Float4);
}

static void spread(const GridNode& value, const CellPlace& place, GridNode* corner) {
    Places cubic[4];
    cubic_spline(*reinterpret_cast<const Places*>(place.t), cubic);
    Float4 w[4];
    to_floats(cubic, 4, w);
    Floats v[kCount];
    for (int i = 0; i < kCount; ++i)
        v[i] = get(value.moments, i);
    for (int z = 0; z < 4; ++z)
        for (int y = 0; y < 4; ++y) {
            const float weight = w[z][2] * w[y][1];
            GridNode* nodes = corner + (z * kBox + y) * kBox;
            for (int i = 0; i < kCount; ++i) {
                const Floats weighted = weight * v[i];
                for (int x = 0; x < 4; ++x)
                    get(nodes[x].moments, i) += w[x][0] * weighted;
            }
        }
}

static void interpolate(const GridNode* corner, const CellPlace& place, PointSums& sums) {
    const Places t = *reinterpret_cast<const Places*>(place.t);
    Places cubic[4], quartic[5], derivatives[5];
    cubic_spline(t, cubic);
    quartic_spline(t, cubic, quartic, derivatives);
    Float4 w[5], d[5];
    to_floats(quartic, 5, w);
    to_floats(derivatives, 5, d);
    for (int i = 0; i < kCount; ++i) {
        const bool first = i < kFirst;
        Floats value{}, dx{}, dy{}, dz{};
        for (int z = 0; z < 5; ++z) {
            Floats plane{}, plane_dx{}, plane_dy{};
            for (int y = 0; y < 5; ++y) {
                const GridNode* nodes = corner + (z * kBox + y) * kBox;
                Floats row{}, row_dx{};
                for (int x = 0; x < 5; ++x) {
                    const Floats g = get(nodes[x].moments, i);
                    row += w[x][0] * g;
                    if (first) row_dx += d[x][0] * g;
                }
                plane += w[y][1] * row;
                if (!first) continue;
                plane_dx += w[y][1] * row_dx;
                plane_dy += d[y][1] * row;
            }
            value += w[z][2] * plane;
            if (!first) continue;
            dx += w[z][2] * plane_dx;
            dy += w[z][2] * plane_dy;
            dz += d[z][2] * plane;
        }
        get(sums.moments, i) = value;
        if (!first) continue;
        get(sums.derivatives[0], i) = dx;
        get(sums.derivatives[1], i) = dy;
        get(sums.derivatives[2], i) = dz;
    }
}

/// The first of the four nodes of a row along an axis, 0 <= row < 16.
static inline int row_begin(int axis, int row) {
    return axis == 0 ? 4 * row : axis == 1 ? 16 * (row / 4) + row % 4 : row;
}

static void convolve(const ConvolutionInput& input, GridNode* output) {
    const int stride = input.axis == 0 ? 1 : input.axis == 1 ? 4 : 16;
    constexpr int together = 2;  // vectors of a node, as many as fit registers
    for (int row = 0; row < 16; ++row) {
        const int begin = row_begin(input.axis, row);
        for (int first = 0; first < kCount; first += together) {
            Floats sum[together][kBlock]{};
            for (int b = 0; b < input.count; ++b) {
                if (!input.blocks[b]) continue;
                const GridNode* in = input.blocks[b] + begin;
                const float* taps = input.taps + kBlock * (b - input.count / 2);
                for (int k = 0; k < kBlock; ++k)
                    for (int i = 0; i < together; ++i) {
                        const Floats g = get(in[k * stride].moments, first + i);
                        for (int j = 0; j < kBlock; ++j)
                            sum[i][j] += taps[k - j] * g;
                    }
            }
            for (int j = 0; j < kBlock; ++j)
                for (int i = 0; i < together; ++i)
                    get(output[begin + j * stride].moments, first + i) = sum[i][j];
        }
    }
}

}  // namespace SIMD_SET

template <>
const GridLoops& functions_of<GridLoops, InstructionSet::SIMD_SET>() {
    using namespace SIMD_SET;
    static constexpr GridLoops functions = {spread, interpolate, convolve};
    return functions;
}

}  // namespace laplacian_lines
