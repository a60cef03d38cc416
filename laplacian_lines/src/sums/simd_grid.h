// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace laplacian_lines {

constexpr int kBlock = 4;         ///< nodes along a block's side
constexpr int kBlockNodes = 64;   ///< x runs fastest, then y
constexpr int kBox = 2 * kBlock;  ///< nodes along the box that a block's points reach
constexpr int kBoxNodes = kBox * kBox * kBox;
constexpr int kMoments = 16;  ///< numbers in one of the two groups of a node's moments

/// Two groups of moments, see set_moments().
struct alignas(64) GridNode {
    GridNode() {}  // nothing is cleared
    float moments[2 * kMoments];
};

/// 0..1 along x, y and z; the fourth is not used.
struct alignas(32) CellPlace {
    double t[4];
};

/// With the derivatives (in cells) of the first group.
struct alignas(64) PointSums {
    float moments[2 * kMoments];
    float derivatives[3][kMoments];
};

/// What a convolution along one axis reads: `count` blocks in a row around the output.
struct ConvolutionInput {
    const GridNode* const* blocks;  ///< null: all zero
    int count;
    const float* taps;  ///< taps[d]: from node i to i − d; valid for |d| <= 4 (count / 2) + 3
    int axis;           ///< 0, 1, 2: along x, y, z
};

/// See simd_sets.h.
struct GridLoops {
    /// Adds `value` times the point's cubic B-splines to the 4 x 4 x 4 nodes from `corner` on in a
    /// box of kBox nodes a side.
    void (*spread)(const GridNode& value, const CellPlace& place, GridNode* corner);
    /// Interpolates by quartic B-splines from the 5 x 5 x 5 nodes from `corner` on in such a box.
    void (*interpolate)(const GridNode* corner, const CellPlace& place, PointSums& sums);

    /// Sets all nodes of the block `output`.
    void (*convolve)(const ConvolutionInput& input, GridNode* output);
};

}  // namespace laplacian_lines
