// SPDX-License-Identifier: GPL-3.0-or-later
#include "sums/simd_grid.h"

#include "sums/spline_kernel.h"
#include "system/simd_sets.h"
#include "system/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_SET {

template <class Real, int Groups>
struct Moments {
    using Lane = decltype(load(static_cast<const Real*>(nullptr)));
    static constexpr int kLane = int(sizeof(Lane) / sizeof(Real));
    static constexpr int kFirst = kMoments / kLane;  // vectors in the first group
    static constexpr int kCount = Groups * kFirst;

    static inline const Lane& get(const Real* moments, int i) {
        return reinterpret_cast<const Lane*>(moments)[i];
    }
    static inline Lane& get(Real* moments, int i) { return reinterpret_cast<Lane*>(moments)[i]; }
};

typedef double Places __attribute__((vector_size(32)));  // along x, y, z

template <class Real, int Count>
struct Splines {
    typedef Real Axes __attribute__((vector_size(4 * sizeof(Real))));
    Axes at[Count];

    void set(const Places* values) {
        for (int k = 0; k < Count; ++k)
            at[k] = __builtin_convertvector(values[k], Axes);
    }
};

template <class Real, int Groups>
static void spread(const GridNode<Real, Groups>& value, const CellPlace& place,
                   GridNode<Real, Groups>* corner) {
    using V = Moments<Real, Groups>;
    Places cubic[4];
    cubic_spline(*reinterpret_cast<const Places*>(place.t), cubic);
    Splines<Real, 4> w;
    w.set(cubic);
    typename V::Lane v[V::kCount];
    for (int i = 0; i < V::kCount; ++i)
        v[i] = V::get(value.moments, i);
    for (int z = 0; z < 4; ++z)
        for (int y = 0; y < 4; ++y) {
            const Real weight = w.at[z][2] * w.at[y][1];
            GridNode<Real, Groups>* nodes = corner + (z * kBox + y) * kBox;
            for (int i = 0; i < V::kCount; ++i) {
                const typename V::Lane weighted = weight * v[i];
                for (int x = 0; x < 4; ++x)
                    V::get(nodes[x].moments, i) += w.at[x][0] * weighted;
            }
        }
}

template <class Real, int Groups>
static void interpolate(const GridNode<Real, Groups>* corner, const CellPlace& place,
                        PointSums<Real, Groups>& sums) {
    using V = Moments<Real, Groups>;
    using Lane = typename V::Lane;
    const Places t = *reinterpret_cast<const Places*>(place.t);
    Places cubic[4], quartic[5], derivatives[5];
    cubic_spline(t, cubic);
    quartic_spline(t, cubic, quartic, derivatives);
    Splines<Real, 5> w, d;
    w.set(quartic);
    d.set(derivatives);
    for (int i = 0; i < V::kCount; ++i) {
        const bool first = i < V::kFirst;
        Lane value{}, dx{}, dy{}, dz{};
        for (int z = 0; z < 5; ++z) {
            Lane plane{}, plane_dx{}, plane_dy{};
            for (int y = 0; y < 5; ++y) {
                const GridNode<Real, Groups>* nodes = corner + (z * kBox + y) * kBox;
                Lane row{}, row_dx{};
                for (int x = 0; x < 5; ++x) {
                    const Lane g = V::get(nodes[x].moments, i);
                    row += w.at[x][0] * g;
                    if (first) row_dx += d.at[x][0] * g;
                }
                plane += w.at[y][1] * row;
                if (!first) continue;
                plane_dx += w.at[y][1] * row_dx;
                plane_dy += d.at[y][1] * row;
            }
            value += w.at[z][2] * plane;
            if (!first) continue;
            dx += w.at[z][2] * plane_dx;
            dy += w.at[z][2] * plane_dy;
            dz += d.at[z][2] * plane;
        }
        V::get(sums.moments, i) = value;
        if (!first) continue;
        V::get(sums.derivatives[0], i) = dx;
        V::get(sums.derivatives[1], i) = dy;
        V::get(sums.derivatives[2], i) = dz;
    }
}

/// Calls visit(node of the box, node of the block) for the first of the four of each row.
template <class Visit>
static inline void for_each_row(int part, unsigned rows, Visit visit) {
    const int first = (((part >> 2) * kBox + (part >> 1 & 1)) * kBox + (part & 1)) * kBlock;
    for (; rows; rows &= rows - 1) {
        const int row = __builtin_ctz(rows);
        visit(first + (row / kBlock * kBox + row % kBlock) * kBox, row * kBlock);
    }
}

template <class Real, int Groups>
static void clear_rows(int part, RowMask rows, GridNode<Real, Groups>* box) {
    using V = Moments<Real, Groups>;
    for_each_row(part, rows, [&](int in_box, int) {
        for (int i = 0; i < kBlock * V::kCount; ++i)
            V::get(box[in_box].moments, i) = typename V::Lane{};
    });
}

template <class Real, int Groups>
static void copy_rows(int part, RowMask rows, const GridNode<Real, Groups>* block,
                      GridNode<Real, Groups>* box) {
    using V = Moments<Real, Groups>;
    for_each_row(part, rows, [&](int in_box, int in_block) {
        for (int i = 0; i < kBlock * V::kCount; ++i)
            V::get(box[in_box].moments, i) = V::get(block[in_block].moments, i);
    });
}

template <class Real, int Groups>
static void add_rows(int part, RowMask rows, const GridNode<Real, Groups>* box,
                     GridNode<Real, Groups>* block) {
    using V = Moments<Real, Groups>;
    for_each_row(part, rows, [&](int in_box, int in_block) {
        for (int i = 0; i < kBlock * V::kCount; ++i)
            V::get(block[in_block].moments, i) += V::get(box[in_box].moments, i);
    });
}

static inline int row_begin(int axis, int row) {
    return axis == 0 ? 4 * row : axis == 1 ? 16 * (row / 4) + row % 4 : row;
}

template <class Real, int Groups>
static void convolve(const ConvolutionInput<Real, Groups>& input, RowMask rows,
                     GridNode<Real, Groups>* output) {
    using V = Moments<Real, Groups>;
    using Lane = typename V::Lane;
    const int stride = input.axis == 0 ? 1 : input.axis == 1 ? 4 : 16;
    constexpr int together = V::kCount < 2 ? V::kCount : 2;  // that registers have room for
    for (int row = 0; row < 16; ++row) {
        const int begin = row_begin(input.axis, row);
        const int count = rows >> row & 1 ? input.count : 0;
        for (int first = 0; first < V::kCount; first += together) {
            Lane sum[together][kBlock]{};
            for (int b = 0; b < count; ++b) {
                if (!(input.rows[b] >> row & 1)) continue;
                const GridNode<Real, Groups>* in = input.blocks[b] + begin;
                const Real* taps = input.taps + kBlock * (b - input.count / 2);
                for (int k = 0; k < kBlock; ++k)
                    for (int i = 0; i < together; ++i) {
                        const Lane g = V::get(in[k * stride].moments, first + i);
                        for (int j = 0; j < kBlock; ++j)
                            sum[i][j] += taps[k - j] * g;
                    }
            }
            for (int j = 0; j < kBlock; ++j)
                for (int i = 0; i < together; ++i)
                    V::get(output[begin + j * stride].moments, first + i) = sum[i][j];
        }
    }
}

template <class Real, int Groups>
static constexpr GridLoops<Real, Groups> kGridLoops = {
    spread<Real, Groups>,    interpolate<Real, Groups>, clear_rows<Real, Groups>,
    copy_rows<Real, Groups>, add_rows<Real, Groups>,    convolve<Real, Groups>};

}  // namespace SIMD_SET

#define LAPLACIAN_LINES_GRID_LOOPS(Real, Groups)                        \
    template <>                                                         \
    const GridLoops<Real, Groups>&                                      \
    functions_of<GridLoops<Real, Groups>, InstructionSet::SIMD_SET>() { \
        return SIMD_SET::kGridLoops<Real, Groups>;                      \
    }
LAPLACIAN_LINES_GRID_LOOPS(float, 1)
LAPLACIAN_LINES_GRID_LOOPS(float, 2)
LAPLACIAN_LINES_GRID_LOOPS(double, 1)
LAPLACIAN_LINES_GRID_LOOPS(double, 2)

}  // namespace laplacian_lines
