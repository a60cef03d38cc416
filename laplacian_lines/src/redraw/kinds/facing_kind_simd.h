// SPDX-License-Identifier: GPL-3.0-or-later
// What kinds of lines share that are drawn on what faces the eye.
#pragma once

#include "redraw/simd/simd_memory.h"
#include "redraw/simd/simd_signs.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// See simd_kinds.h; kForms, kSlope, find_signs(), source() and test() are a kind's own.
struct FacingKind {
    static constexpr bool kHasLeastFacing = true;

    static inline bool may_hold(float least_facing, float, float high) {
        return !(high < least_facing);
    }

    static inline const float* values(const Batch& batch, unsigned number) {
        return batch.values[number];
    }

    static inline std::uint64_t unwanted(const LineRules& rules, const Cluster& cluster,
                                         unsigned group) {
        const std::uint64_t* convex =
            rules.cut_by_convex() ? cluster.convex : cluster.convex_around;
        return (rules.leave_out_convex ? convex[group] : 0) |
               (rules.leave_out_plain ? cluster.plain[group] : 0);
    }
};

}  // namespace SIMD_SET
}  // namespace laplacian_lines
