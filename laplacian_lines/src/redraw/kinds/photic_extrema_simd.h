// SPDX-License-Identifier: GPL-3.0-or-later
// Photic extremum lines: the zeros of Hess I(g, g), g = ∇I, where ‖g‖ is largest along g.
#pragma once

#include "redraw/kinds/laplacian_lines_simd.h"
#include "redraw/simd/simd_columns.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// Hess I(g, g) = C(g, g, l) − (n·l) ‖S g‖² − w g·S g at the vertices of a cluster, in the places
/// of the forms.
static inline void evaluate_photic(const ClusterInSlot& place, const float light[4],
                                   float* values) {
    const unsigned count = place.cluster.vertex_count;
    const Vectors e = {Floats{} + light[0], Floats{} + light[1], Floats{} + light[2]};
    for (unsigned i = 0; i < form_groups(place.cluster) * kFormGroup; i += kLanes) {
        const CurvatureColumns p(curvatures_of(place), i, count);
        const Vectors to_light = e - p.position * (Floats{} + light[3]);
        const Tangents l = p.tangent(to_light), g = p.S(l), sg = p.S(g);
        store(values + i,
              p.C(g, g, l) - dot(p.normal, to_light) * dot(sg, sg) - light[3] * dot(g, sg));
    }
}

/// Makes the gradients g of crossings g/‖g‖³, with which the slope of a segment becomes the second
/// derivative of ‖g‖ along g.
static inline void scale_photic_gradients(CrossingMemory& m, std::size_t count) {
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Floats g = load(m.gradient + i), factor = 1 / (g * g * g);
        for (float* const column : {m.gx, m.gy, m.gz})
            store(column + i, load(column + i) * factor);
    }
    store_gradients(m, count);
}

/// See simd_kinds.h.
struct PhoticExtrema : FacingKind {
    static constexpr LineKind kKind = LineKind::PhoticExtremum;
    static constexpr unsigned kForms = kCurvatures;
    static constexpr SegmentSlope kSlope = SegmentSlope::AlongOnce;

    static inline BelowBound find_signs(const ExtractionTask& task, const ClusterInSlot& place,
                                        const BelowBound&, float* values) {
        float* own = in_slot(values, place);
        evaluate_photic(place, task.light, own);
        return below(own, form_groups(place.cluster), 0);
    }

    static inline const float* source(const ExtractionTask& task) { return task.light; }

    static inline void test(const LineRules& rules, const ExtractionTask& task, const Batch& batch,
                            CrossingMemory& m, std::size_t count) {
        LaplacianLines::test(rules, task, batch, m, count);
        scale_photic_gradients(m, count);
    }
};

}  // namespace SIMD_SET
}  // namespace laplacian_lines
