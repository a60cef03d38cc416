// SPDX-License-Identifier: GPL-3.0-or-later
// Laplacian lines: the zeros of ΔI = Δn·l.
#pragma once

#include "laplacian_lines/line_kind.h"
#include "redraw/kinds/facing_kind_simd.h"
#include "redraw/simd/simd_crossings.h"
#include "redraw/simd/simd_segments.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// How the surface curves towards the light vector l at crossings [i, i + kLanes): −l·Sl, and ‖w‖
/// of l's tangential part w. The cosine between −∇I and w is −l·Sl/(‖w‖‖∇I‖), since ∇I = Sl.
struct Concavity {
    Floats product, tangential;
};
static inline Concavity concavity_towards(Towards light, const CrossingMemory& m, std::size_t i) {
    const Floats lit = load(m.lit + i);
    const Floats product =
        light.x * load(m.gx + i) + light.y * load(m.gy + i) + light.z * load(m.gz + i);
    return {-product, square_root(at_least(light.squared - lit * lit, 0))};
}

/// Which crossings of ΔI are accepted, and their opacities: thresholds on gradient and facing,
/// fading near contours, and concavity. `facing` is n·eye. Of whole lines facing decides, and what
/// is clearly convex goes.
static inline void test_laplacian_crossings(const LineRules& rules, const ExtractionTask& task,
                                            const float* facings, CrossingMemory& m,
                                            std::size_t count) {
    const float least = -rules.fading / 4, range = rules.fading / 2 - least;
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Floats facing = load(facings + i), gradient = load(m.gradient + i);
        const Towards eye = towards(task.eye, m, i);
        Ints accepted = facing >= rules.least_facing * square_root(eye.squared);
        Floats opacity = Floats{} + 1;
        if (rules.contour_clearance > 0) {
            // To first order the contour is I/‖∇I‖ away on the surface, which is seen at half the
            // crossing's cosine on the way there.
            const Floats distance = facing * absolute(facing) / (2 * gradient);
            opacity = clamp01(2 * distance / rules.contour_clearance - 1);
        }
        if (rules.concave_only) {
            const Concavity concave =
                concavity_towards(task.light_at_eye ? eye : towards(task.light, m, i), m, i);
            if (rules.whole) {
                const Floats part = concave.product / concave.tangential;
                const Floats most = part < gradient ? part : gradient;
                const Floats clamped = part > -gradient ? most : -gradient;  // that for NaN
                store(m.concave + i, clamped);
                accepted &= clamped >= rules.least_concavity * gradient;
            } else {
                const Floats concavity = concave.product / (concave.tangential * gradient);
                if (range > 0) opacity *= clamp01((concavity - least) / range);
                accepted &= concavity > least;  // not so for NaN
            }
        }
        if (!rules.whole) accepted &= gradient >= rules.least_gradient;
        store(m.opacity + i, opacity);
        accept(accepted, m, i);
    }
}

/// See simd_kinds.h.
struct LaplacianLines : FacingKind {
    static constexpr LineKind kKind = LineKind::Laplacian;
    static constexpr unsigned kForms = 1u << kLaplacianForm;
    static constexpr SegmentSlope kSlope = SegmentSlope::Scaled;

    static inline BelowBound find_signs(const ExtractionTask& task, const ClusterInSlot& place,
                                        const BelowBound&, float* values) {
        const unsigned groups = form_groups(place.cluster);
        float* own = in_slot(values, place);
        evaluate(place.laplacians, groups, task.light, own);
        return below(own, groups, 0);
    }

    static inline const float* source(const ExtractionTask& task) { return task.light; }

    static inline void test(const LineRules& rules, const ExtractionTask& task, const Batch& batch,
                            CrossingMemory& m, std::size_t count) {
        if (!task.light_at_eye) find_facing(batch, task.eye, m, count);
        test_laplacian_crossings(rules, task, task.light_at_eye ? m.lit : m.facing, m, count);
    }
};

}  // namespace SIMD_SET
}  // namespace laplacian_lines
