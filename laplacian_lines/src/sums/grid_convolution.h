// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "sums/grid_points.h"
#include "sums/grid_slabs.h"
#include "sums/spline_kernel.h"
#include "system/parallel.h"
#include "system/simd_sets.h"

namespace laplacian_lines {

constexpr int kMaxReach = 16;  ///< blocks that a convolution may reach to either side

/// Nodes to each side of a value half way between two of them; size: √h in cells.
inline int tap_count(double size, const GridResolution& resolution) {
    return int(std::ceil(resolution.cutoff * size + 0.5));
}

/// spline_kernel() as a row: taps[size / 2 + d] goes from node i to the value half a cell after
/// node i − d. Zero-padded to whole blocks.
template <class Real>
std::vector<Real> kernel_taps(double size, const GridResolution& resolution, int reach) {
    const int count = tap_count(size, resolution), middle = kBlock * reach + kBlock - 1;
    const std::vector<double> half = spline_kernel(std::sqrt(2.0) * size, count);
    std::vector<Real> taps(std::size_t(2 * middle + 1), Real(0));
    for (int i = 0; i < count; ++i)
        taps[std::size_t(middle + i + 1)] = taps[std::size_t(middle - i)] =
            Real(half[std::size_t(i)]);
    return taps;
}

/// Convolves masses on a grid with one kernel, along x and y inside slabs and along z across them,
/// at the nodes that can be reached and that the targets need.
template <class Real, int Groups>
class GridConvolution {
    using Node = GridNode<Real, Groups>;
    using Slab = BlockSlab<Node>;

public:
    /// `targets`: the nodes wanted. `reach`: blocks that the taps reach to either side.
    GridConvolution(const GridGeometry& grid, const std::vector<BlockMask>& targets, int reach,
                    std::vector<Real> taps)
        : grid_(grid),
          targets_(targets),
          reach_(reach),
          taps_(std::move(taps)),
          y_(std::size_t(2 * reach + 1)) {}

    /// Call for every slab in turn, and for `reach` empty ones after the last.
    void add_slab(int slab, const Slab& masses) {
        Slab& y = y_[std::size_t(slab) % y_.size()];
        if (slab >= grid_.blocks[2]) {
            y.masks().assign(grid_.sites(), 0);
            y.allocate();
            return;
        }
        find_nodes_needed(slab);
        x_.masks() = needed_after_x_;
        convolve_beside(0, masses, x_);
        y.masks() = needed_after_y_;
        convolve_beside(1, x_, y);
    }

    /// Needs `reach` more slabs to have been added.
    void finish_slab(int slab) {
        const auto at = [&](int j) -> const Slab& { return y_[std::size_t(slab + j) % y_.size()]; };
        Slab& z = z_[slab % 2];
        const auto begin = targets_.begin() + std::ptrdiff_t(slab) * std::ptrdiff_t(grid_.sites());
        z.masks().assign(begin, begin + std::ptrdiff_t(grid_.sites()));
        z.allocate();
        convolve_blocks(
            2, z,
            [&](std::size_t site, int j) -> const Node* {
                return slab + j < 0 ? nullptr : at(j).block(site);
            },
            [&](std::size_t site, int j) { return at(j).mask(site); });
    }

    /// Of the last two finished slabs.
    const Slab& result(int slab) const { return z_[slab % 2]; }

private:
    /// Rows along the axis with a node of any mask at(j), |j| <= reach.
    template <class At>
    RowMask rows_around(int axis, At at) const {
        RowMask rows = 0;
        for (int j = -reach_; j <= reach_; ++j)
            rows = RowMask(rows | rows_of(at(j), axis));
        return rows;
    }

    /// Calls at(j) for the sites in reach along x or y, with 0 outside the slab.
    template <class At>
    RowMask rows_beside(int axis, std::size_t site, At at) const {
        const int place = axis == 0 ? int(site) % grid_.blocks[0] : int(site) / grid_.blocks[0];
        const std::ptrdiff_t stride = axis == 0 ? 1 : grid_.blocks[0];
        return rows_around(axis, [&](int j) -> BlockMask {
            if (place + j < 0 || place + j >= grid_.blocks[axis]) return 0;
            return at(std::size_t(std::ptrdiff_t(site) + j * stride));
        });
    }

    /// Nodes of a slab that the convolution along z will read.
    void find_nodes_needed(int slab) {
        needed_after_y_.assign(grid_.sites(), 0);
        needed_after_x_.assign(grid_.sites(), 0);
        for (int l = std::max(0, slab - reach_); l <= std::min(grid_.blocks[2] - 1, slab + reach_);
             ++l)
            for (std::size_t c = 0; c < grid_.sites(); ++c)
                needed_after_y_[c] |= targets_[std::size_t(l) * grid_.sites() + c];
        for (BlockMask& mask : needed_after_y_)
            if (mask) mask = nodes_of(rows_of(mask, 2), 2);
        for (std::size_t c = 0; c < grid_.sites(); ++c)
            needed_after_x_[c] =
                nodes_of(rows_beside(1, c, [&](std::size_t o) { return needed_after_y_[o]; }), 1);
    }

    /// Convolves `from` into `to`, whose masks say what is needed, along x or y.
    void convolve_beside(int axis, const Slab& from, Slab& to) {
        for (std::size_t c = 0; c < to.masks().size(); ++c)
            if (to.masks()[c])
                to.masks()[c] &= nodes_of(
                    rows_beside(axis, c, [&](std::size_t o) { return from.mask(o); }), axis);
        to.allocate();
        const std::ptrdiff_t stride = axis == 0 ? 1 : grid_.blocks[0];
        convolve_blocks(
            axis, to,
            [&](std::size_t site, int j) -> const Node* {
                const int place =
                    axis == 0 ? int(site) % grid_.blocks[0] : int(site) / grid_.blocks[0];
                if (place + j < 0 || place + j >= grid_.blocks[axis]) return nullptr;
                return from.block(std::size_t(std::ptrdiff_t(site) + j * stride));
            },
            [&](std::size_t site, int j) {
                return from.mask(std::size_t(std::ptrdiff_t(site) + j * stride));
            });
    }

    template <class BlockAt, class MaskAt>
    void convolve_blocks(int axis, Slab& to, BlockAt block_at, MaskAt mask_at) {
        in_parallel(to.sites().size(), [&](std::size_t i) {
            const std::size_t site = to.sites()[i];
            const Node* blocks[2 * kMaxReach + 1];
            RowMask rows[2 * kMaxReach + 1];
            for (int j = -reach_; j <= reach_; ++j) {
                blocks[j + reach_] = block_at(site, j);
                rows[j + reach_] =
                    blocks[j + reach_] ? rows_of(mask_at(site, j), axis) : RowMask(0);
            }
            const ConvolutionInput<Real, Groups> input = {blocks, rows, 2 * reach_ + 1,
                                                          taps_.data() + taps_.size() / 2, axis};
            fastest<GridLoops<Real, Groups>>().convolve(input, rows_of(to.mask(site), axis),
                                                        to.block(site));
        });
    }

    const GridGeometry& grid_;
    const std::vector<BlockMask>& targets_;
    const int reach_;
    std::vector<Real> taps_;
    std::vector<BlockMask> needed_after_x_, needed_after_y_;
    Slab x_;
    std::vector<Slab> y_;  // slab l is kept at l modulo the size
    Slab z_[2];
};

}  // namespace laplacian_lines
