// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace laplacian_lines {

using BlockMask = std::uint64_t;  ///< one bit for each node of a block, see simd_grid.h
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

}  // namespace laplacian_lines
