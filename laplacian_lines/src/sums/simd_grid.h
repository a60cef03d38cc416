// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sums/block_rows.h"

namespace laplacian_lines {

constexpr int kBlock = 4;         ///< nodes along a block's side
constexpr int kBlockNodes = 64;   ///< x runs fastest, then y
constexpr int kBox = 2 * kBlock;  ///< nodes along the box that a block's points reach
constexpr int kBoxNodes = kBox * kBox * kBox;
constexpr int kMoments = 16;  ///< numbers in a group of a node's moments

/// `Groups` groups of 16 numbers, see normal_moments.h.
template <class Real, int Groups>
struct alignas(64) GridNode {
    Real moments[Groups * kMoments];
};

/// 0..1 along x, y and z; the fourth is not used.
struct alignas(32) CellPlace {
    double t[4];
};

/// With the derivatives (in cells) of the first group.
template <class Real, int Groups>
struct alignas(64) PointSums {
    Real moments[Groups * kMoments];
    Real derivatives[3][kMoments];
};

/// What a convolution along one axis reads: `count` blocks in a row around the output.
template <class Real, int Groups>
struct ConvolutionInput {
    const GridNode<Real, Groups>* const* blocks;  ///< null: all zero
    const RowMask* rows;  ///< by block: bits of the rows along the axis that are not zero
    int count;
    const Real* taps;  ///< taps[d]: from node i to i − d; valid for |d| <= 4 (count / 2) + 3
    int axis;
};

/// See simd_sets.h. For float and double, Groups 1 and 2.
template <class Real, int Groups>
struct GridLoops {
    using Node = GridNode<Real, Groups>;

    /// Adds `value` times the point's cubic B-splines to the 4 x 4 x 4 nodes from `corner` on in a
    /// box of kBox nodes a side.
    void (*spread)(const Node& value, const CellPlace& place, Node* corner);
    /// Interpolates by quartic B-splines from the 5 x 5 x 5 nodes from `corner` on in such a box.
    void (*interpolate)(const Node* corner, const CellPlace& place, PointSums<Real, Groups>& sums);

    // The box of one block's points overlaps eight blocks; bits 0, 1, 2 of `part`: the next one
    // along x, y, z. These run over one part's rows of four nodes along x: clearing them, copying
    // from a block, adding to it.
    void (*clear_rows)(int part, RowMask rows, Node* box);
    void (*copy_rows)(int part, RowMask rows, const Node* block, Node* box);
    void (*add_rows)(int part, RowMask rows, const Node* box, Node* block);

    /// Computes a block's rows whose bits are set, and zeroes the others. Row l holds the nodes
    /// from 4l along x, from 16 (l / 4) + l % 4 along y, from l along z.
    void (*convolve)(const ConvolutionInput<Real, Groups>& input, RowMask rows, Node* output);
};

}  // namespace laplacian_lines
