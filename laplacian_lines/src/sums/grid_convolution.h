// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "sums/grid_points.h"
#include "system/large_array.h"
#include "system/parallel.h"
#include "system/simd_sets.h"

namespace laplacian_lines {

/// Room for so many nodes, whose values are lost if it grows.
inline GridNode* grow(std::vector<GridNode>& nodes, std::size_t count) {
    if (nodes.size() < count) nodes = large_array<GridNode>(count + count / 4);
    return nodes.data();
}

/// The blocks of a slab that hold anything.
class BlockSlab {
public:
    std::vector<BlockMask>& masks() { return masks_; }  ///< by site; set them, then allocate()
    BlockMask mask(std::size_t site) const { return masks_.empty() ? 0 : masks_[site]; }

    void allocate() {
        sites_.clear();
        slots_.resize(masks_.size());
        for (std::size_t c = 0; c < masks_.size(); ++c)
            if (masks_[c]) {
                slots_[c] = std::uint32_t(sites_.size());
                sites_.push_back(std::uint32_t(c));
            }
        first_node_ = grow(nodes_, sites_.size() * kBlockNodes);
    }

    const std::vector<std::uint32_t>& sites() const { return sites_; }
    /// Null if empty.
    GridNode* block(std::size_t site) const {
        return mask(site) ? first_node_ + std::size_t(slots_[site]) * kBlockNodes : nullptr;
    }

private:
    std::vector<BlockMask> masks_;
    std::vector<std::uint32_t> sites_, slots_;
    std::vector<GridNode> nodes_;
    GridNode* first_node_ = nullptr;
};

constexpr int kMaxReach = 16;  ///< blocks that a convolution may reach to either side

/// Convolves masses on a grid with one kernel, along x and y inside slabs and along z across them,
/// at the nodes that can be reached and that the targets need.
class GridConvolution {
public:
    /// `targets`: the nodes wanted. `reach`: blocks that the taps reach to either side.
    GridConvolution(const GridGeometry& grid, const std::vector<BlockMask>& targets, int reach,
                    std::vector<float> taps)
        : grid_(grid),
          targets_(targets),
          reach_(reach),
          taps_(std::move(taps)),
          y_(std::size_t(2 * reach + 1)) {}

    /// Call for every slab in turn, and for `reach` empty ones after the last.
    void add_slab(int slab, const BlockSlab& masses) {
        BlockSlab& y = y_[std::size_t(slab) % y_.size()];
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
        const auto at = [&](int j) -> const BlockSlab& {
            return y_[std::size_t(slab + j) % y_.size()];
        };
        BlockSlab& z = z_[slab % 2];
        const auto begin = targets_.begin() + std::ptrdiff_t(slab) * std::ptrdiff_t(grid_.sites());
        z.masks().assign(begin, begin + std::ptrdiff_t(grid_.sites()));
        z.allocate();
        convolve_blocks(
            2, z,
            [&](std::size_t site, int j) -> const GridNode* {
                return slab + j < 0 ? nullptr : at(j).block(site);
            },
            [&](std::size_t site, int j) { return at(j).mask(site); });
    }

    /// Of the last two finished slabs.
    const BlockSlab& result(int slab) const { return z_[slab % 2]; }

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
    void convolve_beside(int axis, const BlockSlab& from, BlockSlab& to) {
        for (std::size_t c = 0; c < to.masks().size(); ++c)
            if (to.masks()[c])
                to.masks()[c] &= nodes_of(
                    rows_beside(axis, c, [&](std::size_t o) { return from.mask(o); }), axis);
        to.allocate();
        const std::ptrdiff_t stride = axis == 0 ? 1 : grid_.blocks[0];
        convolve_blocks(
            axis, to,
            [&](std::size_t site, int j) -> const GridNode* {
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
    void convolve_blocks(int axis, BlockSlab& to, BlockAt block_at, MaskAt mask_at) {
        in_parallel(to.sites().size(), [&](std::size_t i) {
            const std::size_t site = to.sites()[i];
            const GridNode* blocks[2 * kMaxReach + 1];
            RowMask rows[2 * kMaxReach + 1];
            for (int j = -reach_; j <= reach_; ++j) {
                blocks[j + reach_] = block_at(site, j);
                rows[j + reach_] =
                    blocks[j + reach_] ? rows_of(mask_at(site, j), axis) : RowMask(0);
            }
            const ConvolutionInput input = {blocks, rows, 2 * reach_ + 1,
                                            taps_.data() + taps_.size() / 2, axis};
            fastest<GridLoops>().convolve(input, rows_of(to.mask(site), axis), to.block(site));
        });
    }

    const GridGeometry& grid_;
    const std::vector<BlockMask>& targets_;
    const int reach_;
    std::vector<float> taps_;
    std::vector<BlockMask> needed_after_x_, needed_after_y_;
    BlockSlab x_;
    std::vector<BlockSlab> y_;  // slab l is kept at l modulo the size
    BlockSlab z_[2];
};

}  // namespace laplacian_lines
