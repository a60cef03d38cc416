// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_kernels.h"

#include "simd_clones.h"

namespace laplacian_lines {
namespace {

template <class Real>
struct Lanes;
template <>
struct Lanes<float> {
    typedef float Type __attribute__((vector_size(4 * kMoments)));
};
template <>
struct Lanes<double> {
    // The widest registers hold 8; two of these make a group.
    typedef double Type __attribute__((vector_size(8 * kMoments / 2)));
};

/// A node as vectors.
template <class Real, int Groups>
struct Vectors {
    using Lane = typename Lanes<Real>::Type;
    static constexpr int kLane = int(sizeof(Lane) / sizeof(Real));
    static constexpr int kFirst = kMoments / kLane;  // vectors in the first group
    static constexpr int kCount = Groups * kFirst;

    static LAPLACIAN_LINES_INLINE const Lane& get(const Real* moments, int i) {
        return reinterpret_cast<const Lane*>(moments)[i];
    }
    static LAPLACIAN_LINES_INLINE Lane& get(Real* moments, int i) {
        return reinterpret_cast<Lane*>(moments)[i];
    }
};

template <class Real, int Groups>
LAPLACIAN_LINES_INLINE void spread_any(const GridNode<Real, Groups>& value,
                                       const SpreadWeights<Real>& w,
                                       GridNode<Real, Groups>* corner) {
    using V = Vectors<Real, Groups>;
    typename V::Lane v[V::kCount];
    for (int i = 0; i < V::kCount; ++i)
        v[i] = V::get(value.moments, i);
    for (int z = 0; z < 4; ++z)
        for (int y = 0; y < 4; ++y) {
            const Real weight = w.values[2][z] * w.values[1][y];
            GridNode<Real, Groups>* row = corner + (z * kBox + y) * kBox;
            for (int x = 0; x < 4; ++x)
                for (int i = 0; i < V::kCount; ++i)
                    V::get(row[x].moments, i) += (weight * w.values[0][x]) * v[i];
        }
}

template <class Real, int Groups>
LAPLACIAN_LINES_INLINE void interpolate_any(const GridNode<Real, Groups>* corner,
                                            const InterpolationWeights<Real>& w,
                                            PointSums<Real, Groups>& sums) {
    using V = Vectors<Real, Groups>;
    using Lane = typename V::Lane;
    for (int i = 0; i < V::kCount; ++i) {
        const bool first = i < V::kFirst;
        Lane value{}, dx{}, dy{}, dz{};
        for (int z = 0; z < 5; ++z)
            for (int y = 0; y < 5; ++y) {
                const GridNode<Real, Groups>* row = corner + (z * kBox + y) * kBox;
                Lane r{}, d{};
                for (int x = 0; x < 5; ++x) {
                    const Lane g = V::get(row[x].moments, i);
                    r += w.values[0][x] * g;
                    if (first) d += w.derivatives[0][x] * g;
                }
                const Real weight = w.values[1][y] * w.values[2][z];
                value += weight * r;
                if (!first) continue;
                dx += weight * d;
                dy += (w.derivatives[1][y] * w.values[2][z]) * r;
                dz += (w.values[1][y] * w.derivatives[2][z]) * r;
            }
        V::get(sums.moments, i) = value;
        if (!first) continue;
        V::get(sums.derivatives[0], i) = dx;
        V::get(sums.derivatives[1], i) = dy;
        V::get(sums.derivatives[2], i) = dz;
    }
}

template <class Real, int Groups>
LAPLACIAN_LINES_INLINE void add_line_any(const GridNode<Real, Groups>* from,
                                         GridNode<Real, Groups>* to) {
    using V = Vectors<Real, Groups>;
    for (int i = 0; i < kBlock * V::kCount; ++i)
        V::get(to->moments, i) += V::get(from->moments, i);
}

LAPLACIAN_LINES_INLINE int line_begin(int axis, int line) {
    return axis == 0 ? 4 * line : axis == 1 ? 16 * (line / 4) + line % 4 : line;
}

template <class Real, int Groups>
LAPLACIAN_LINES_INLINE void convolve_any(const ConvolutionInput<Real, Groups>& input,
                                         std::uint16_t lines, GridNode<Real, Groups>* output) {
    using V = Vectors<Real, Groups>;
    using Lane = typename V::Lane;
    const int stride = input.axis == 0 ? 1 : input.axis == 1 ? 4 : 16;
    for (int line = 0; line < 16; ++line) {
        const int begin = line_begin(input.axis, line);
        for (int i = 0; i < V::kCount; ++i) {
            Lane sum[kBlock]{};
            for (int b = 0; b < (lines >> line & 1 ? input.count : 0); ++b) {
                if (!(input.lines[b] >> line & 1)) continue;
                const GridNode<Real, Groups>* in = input.blocks[b] + begin;
                const Real* taps = input.taps + kBlock * (b - input.count / 2);
                for (int k = 0; k < kBlock; ++k) {
                    const Lane g = V::get(in[k * stride].moments, i);
                    for (int j = 0; j < kBlock; ++j)
                        sum[j] += taps[k - j] * g;
                }
            }
            for (int j = 0; j < kBlock; ++j)
                V::get(output[begin + j * stride].moments, i) = sum[j];
        }
    }
}

}  // namespace

// Clones cannot be templates.
#define LAPLACIAN_LINES_GRID_KERNELS(Real, Groups)                                               \
    LAPLACIAN_LINES_CLONES void spread_##Real##Groups(const GridNode<Real, Groups>& value,       \
                                                      const SpreadWeights<Real>& weights,        \
                                                      GridNode<Real, Groups>* corner) {          \
        spread_any(value, weights, corner);                                                      \
    }                                                                                            \
    LAPLACIAN_LINES_CLONES void interpolate_##Real##Groups(                                      \
        const GridNode<Real, Groups>* corner, const InterpolationWeights<Real>& weights,         \
        PointSums<Real, Groups>& sums) {                                                         \
        interpolate_any(corner, weights, sums);                                                  \
    }                                                                                            \
    LAPLACIAN_LINES_CLONES void convolve_##Real##Groups(                                         \
        const ConvolutionInput<Real, Groups>& input, std::uint16_t lines,                        \
        GridNode<Real, Groups>* output) {                                                        \
        convolve_any(input, lines, output);                                                      \
    }                                                                                            \
    LAPLACIAN_LINES_CLONES void add_line_##Real##Groups(const GridNode<Real, Groups>* from,      \
                                                        GridNode<Real, Groups>* to) {            \
        add_line_any(from, to);                                                                  \
    }                                                                                            \
    template <>                                                                                  \
    void add_line(const GridNode<Real, Groups>* from, GridNode<Real, Groups>* to) {              \
        add_line_##Real##Groups(from, to);                                                       \
    }                                                                                            \
    template <>                                                                                  \
    void spread(const GridNode<Real, Groups>& value, const SpreadWeights<Real>& weights,         \
                GridNode<Real, Groups>* corner) {                                                \
        spread_##Real##Groups(value, weights, corner);                                           \
    }                                                                                            \
    template <>                                                                                  \
    void interpolate(const GridNode<Real, Groups>* corner,                                       \
                     const InterpolationWeights<Real>& weights, PointSums<Real, Groups>& sums) { \
        interpolate_##Real##Groups(corner, weights, sums);                                       \
    }                                                                                            \
    template <>                                                                                  \
    void convolve(const ConvolutionInput<Real, Groups>& input, std::uint16_t lines,              \
                  GridNode<Real, Groups>* output) {                                              \
        convolve_##Real##Groups(input, lines, output);                                           \
    }

LAPLACIAN_LINES_GRID_KERNELS(float, 1)
LAPLACIAN_LINES_GRID_KERNELS(float, 2)
LAPLACIAN_LINES_GRID_KERNELS(double, 1)
LAPLACIAN_LINES_GRID_KERNELS(double, 2)

}  // namespace laplacian_lines
