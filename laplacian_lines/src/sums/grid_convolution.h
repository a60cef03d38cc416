// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "sums/grid_points.h"
#include "system/large_array.h"
#include "system/parallel.h"
#include "system/simd_sets.h"

namespace laplacian_lines {

/// Makes room for so many nodes; values are lost if it grows.
inline GridNode* grow(std::vector<GridNode>& nodes, std::size_t count) {
    if (nodes.size() < count) nodes = large_array<GridNode>(count + count / 4);
    return nodes.data();
}

/// The blocks of a slab that hold anything, by site.
class BlockSlab {
public:
    /// Allocates the blocks for which is_needed(site); their values are not set.
    template <class IsNeeded>
    void allocate(std::size_t sites, IsNeeded is_needed) {
        sites_.clear();
        slots_.assign(sites, kNone);
        for (std::size_t c = 0; c < sites; ++c) {
            if (!is_needed(c)) continue;
            slots_[c] = std::uint32_t(sites_.size());
            sites_.push_back(std::uint32_t(c));
        }
        first_node_ = grow(nodes_, sites_.size() * kBlockNodes);
    }

    const std::vector<std::uint32_t>& sites() const { return sites_; }
    /// Null if empty.
    GridNode* block(std::size_t site) const {
        return site < slots_.size() && slots_[site] != kNone
                   ? first_node_ + std::size_t(slots_[site]) * kBlockNodes
                   : nullptr;
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::vector<std::uint32_t> sites_, slots_;
    std::vector<GridNode> nodes_;
    GridNode* first_node_ = nullptr;
};

/// Blocks that a convolution may reach to either side: resolutions that are exact take 12 at most;
/// grid_cost() keeps the others, up to 28, from being used.
constexpr int kMaxReach = 16;

/// Convolves masses on a grid with one kernel, along x and y inside slabs and along z across them,
/// in the blocks that can be reached and that the targets need.
class GridConvolution {
public:
    /// `targets`: the blocks wanted. `reach`: blocks that the taps reach to either side, at most
    /// kMaxReach. `taps`: all of ConvolutionInput's, taps[0] in the middle.
    GridConvolution(const GridGeometry& grid, const std::vector<std::uint8_t>& targets, int reach,
                    std::vector<float> taps)
        : grid_(grid),
          targets_(targets),
          reach_(reach),
          taps_(std::move(taps)),
          y_(std::size_t(2 * reach + 1)) {}

    /// Call for every slab in turn, and for `reach` empty ones after the last.
    void add_slab(int slab, const BlockSlab& masses) {
        BlockSlab& y = y_[std::size_t(slab) % y_.size()];
        if (slab >= grid_.blocks[2]) return y.allocate(0, [](std::size_t) { return false; });
        const std::size_t sites = grid_.sites();
        std::vector<std::uint8_t> needed_after_y(sites, 0);
        for (int l = std::max(0, slab - reach_); l <= std::min(grid_.blocks[2] - 1, slab + reach_);
             ++l)
            for (std::size_t c = 0; c < sites; ++c)
                needed_after_y[c] |= targets_[std::size_t(l) * sites + c];
        x_.allocate(sites, [&](std::size_t c) {
            return any_beside(1, c, [&](std::size_t o) { return needed_after_y[o] != 0; }) &&
                   any_beside(0, c, [&](std::size_t o) { return masses.block(o) != nullptr; });
        });
        convolve_beside(0, masses, x_);
        y.allocate(sites, [&](std::size_t c) {
            return needed_after_y[c] &&
                   any_beside(1, c, [&](std::size_t o) { return x_.block(o) != nullptr; });
        });
        convolve_beside(1, x_, y);
    }

    /// Needs `reach` more slabs to have been added.
    void finish_slab(int slab) {
        BlockSlab& z = z_[slab % 2];
        z.allocate(grid_.sites(), [&](std::size_t c) {
            return targets_[std::size_t(slab) * grid_.sites() + c] != 0;
        });
        convolve_blocks(2, z, [&](std::size_t site, int j) -> const GridNode* {
            return slab + j < 0 ? nullptr : y_[std::size_t(slab + j) % y_.size()].block(site);
        });
    }

    /// Of the last two finished slabs.
    const BlockSlab& result(int slab) const { return z_[slab % 2]; }

private:
    /// The site j blocks further along x or y; grid_.sites() if beyond the slab.
    std::size_t site_beside(int axis, std::size_t site, int j) const {
        const int place = axis == 0 ? int(site) % grid_.blocks[0] : int(site) / grid_.blocks[0];
        if (place + j < 0 || place + j >= grid_.blocks[axis]) return grid_.sites();
        return std::size_t(int(site) + j * (axis == 0 ? 1 : grid_.blocks[0]));
    }

    /// Whether test(site) is true of one in reach.
    template <class Test>
    bool any_beside(int axis, std::size_t site, Test test) const {
        for (int j = -reach_; j <= reach_; ++j) {
            const std::size_t other = site_beside(axis, site, j);
            if (other < grid_.sites() && test(other)) return true;
        }
        return false;
    }

    void convolve_beside(int axis, const BlockSlab& from, BlockSlab& to) const {
        convolve_blocks(axis, to, [&](std::size_t site, int j) -> const GridNode* {
            return from.block(site_beside(axis, site, j));
        });
    }

    template <class BlockAt>
    void convolve_blocks(int axis, BlockSlab& to, BlockAt block_at) const {
        in_parallel(to.sites().size(), [&](std::size_t i) {
            const std::size_t site = to.sites()[i];
            const GridNode* blocks[2 * kMaxReach + 1];
            for (int j = -reach_; j <= reach_; ++j)
                blocks[j + reach_] = block_at(site, j);
            fastest<GridLoops>().convolve(
                {blocks, 2 * reach_ + 1, taps_.data() + taps_.size() / 2, axis}, to.block(site));
        });
    }

    const GridGeometry& grid_;
    const std::vector<std::uint8_t>& targets_;
    const int reach_;
    const std::vector<float> taps_;
    BlockSlab x_;
    std::vector<BlockSlab> y_;  // slab l is kept at l modulo the size
    BlockSlab z_[2];
};

}  // namespace laplacian_lines
