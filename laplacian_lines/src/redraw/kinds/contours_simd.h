// SPDX-License-Identifier: GPL-3.0-or-later
// Occluding contours: the zeros of n·(e − w p).
#pragma once

#include "laplacian_lines/line_kind.h"
#include "redraw/simd/simd_crossings.h"
#include "redraw/simd/simd_segments.h"
#include "redraw/simd/simd_signs.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// Opacities of crossings of contours: 1, less where the surface is concave along the view.
static inline void weigh_contours(const LineRules& rules, const float eye[4], CrossingMemory& m,
                                  std::size_t count) {
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Towards v = towards(eye, m, i);
        const Floats product = v.x * load(m.gx + i) + v.y * load(m.gy + i) + v.z * load(m.gz + i);
        const Floats distance = square_root(v.squared);
        const Floats gradient = load(m.gradient + i) + LineRules::kFlat * distance;
        const Floats concavity = -product / (distance * gradient);
        store(m.opacity + i, 1 - clamp01(concavity / rules.concave_thinning));  // 1 for NaN
    }
}

/// See simd_kinds.h.
struct Contours {
    static constexpr LineKind kKind = LineKind::Contour;
    static constexpr unsigned kForms = 1u << kFacingForm;
    static constexpr SegmentSlope kSlope = SegmentSlope::Scaled;
    static constexpr bool kHasLeastFacing = false;

    static inline bool may_hold(float, float low, float high) { return !(low >= 0) & !(high < 0); }

    /// The function is n·eye, whose signs are known.
    static inline BelowBound find_signs(const ExtractionTask&, const ClusterInSlot&,
                                        const BelowBound& facing, float*) {
        return facing;
    }

    static inline const float* values(const Batch& batch, unsigned) { return batch.facing; }

    static inline std::uint64_t unwanted(const LineRules& rules, const Cluster& cluster,
                                         unsigned group) {
        return rules.leave_out_coarse ? cluster.coarse[group] : 0;
    }

    static inline const float* source(const ExtractionTask& task) { return task.eye; }

    static inline void test(const LineRules& rules, const ExtractionTask& task, const Batch&,
                            CrossingMemory& m, std::size_t count) {
        weigh_contours(rules, task.eye, m, count);
    }
};

}  // namespace SIMD_SET
}  // namespace laplacian_lines
