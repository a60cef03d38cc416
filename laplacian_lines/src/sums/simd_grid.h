// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace laplacian_lines {

constexpr int kBlock = 4;         ///< nodes along a block's side
constexpr int kBlockNodes = 64;   ///< x runs fastest, then y
constexpr int kBox = 2 * kBlock;  ///< nodes along the box that a block's points reach
constexpr int kBoxNodes = kBox * kBox * kBox;
constexpr int kMoments = 16;  ///< numbers in one of the two groups of a node's moments

using BlockMask = std::uint64_t;  ///< one bit for each node of a block
using RowMask = std::uint16_t;    ///< one bit for each row of a block along some axis

/// Rows along an axis that hold a node of the mask.
inline RowMask rows_of(BlockMask nodes, int axis) {
    unsigned rows = 0;
    for (int plane = 0; plane < 4; ++plane) {
        const unsigned bits = nodes >> (16 * plane) & 0xffff;
        if (axis == 2) rows |= bits;
        if (axis == 1) rows |= ((bits | bits >> 4 | bits >> 8 | bits >> 12) & 0xf) << (4 * plane);
        if (axis == 0) {
            const unsigned any = (bits | bits >> 1 | bits >> 2 | bits >> 3) & 0x1111;
            rows |= ((any | any >> 3 | any >> 6 | any >> 9) & 0xf) << (4 * plane);
        }
    }
    return RowMask(rows);
}

inline BlockMask nodes_of(RowMask rows, int axis) {
    if (axis == 2) return rows * 0x0001000100010001ull;
    BlockMask nodes = 0;
    for (int plane = 0; plane < 4; ++plane) {
        const unsigned bits = rows >> (4 * plane) & 0xf;
        const unsigned spread = (bits & 1) | (bits & 2) << 3 | (bits & 4) << 6 | (bits & 8) << 9;
        nodes |= BlockMask(axis == 1 ? bits * 0x1111u : spread * 0xfu) << (16 * plane);
    }
    return nodes;
}

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
    const RowMask* rows;            ///< by block: bits of the rows along the axis that are not zero
    int count;
    const float* taps;  ///< taps[d]: from node i to i − d; valid for |d| <= 4 (count / 2) + 3
    int axis;
};

/// See simd_sets.h.
struct GridLoops {
    /// Adds `value` times the point's cubic B-splines to the 4 x 4 x 4 nodes from `corner` on in a
    /// box of kBox nodes a side.
    void (*spread)(const GridNode& value, const CellPlace& place, GridNode* corner);
    /// Interpolates by quartic B-splines from the 5 x 5 x 5 nodes from `corner` on in such a box.
    void (*interpolate)(const GridNode* corner, const CellPlace& place, PointSums& sums);

    // The box of one block's points overlaps eight blocks; bits 0, 1, 2 of `part`: the next one
    // along x, y, z. These run over one part's rows of four nodes along x: clearing them, copying
    // from a block, adding to it.
    void (*clear_rows)(int part, RowMask rows, GridNode* box);
    void (*copy_rows)(int part, RowMask rows, const GridNode* block, GridNode* box);
    void (*add_rows)(int part, RowMask rows, const GridNode* box, GridNode* block);

    /// Computes a block's rows whose bits are set, and zeroes the others. Row l holds the nodes
    /// from 4l along x, from 16 (l / 4) + l % 4 along y, from l along z.
    void (*convolve)(const ConvolutionInput& input, RowMask rows, GridNode* output);
};

}  // namespace laplacian_lines
