// SPDX-License-Identifier: GPL-3.0-or-later
// Suggestive contours and highlights: the zeros of the radial curvature, of which v·S v with the
// vector to the eye v is a positive multiple.
#pragma once

#include "laplacian_lines/line_kind.h"
#include "redraw/kinds/facing_kind_simd.h"
#include "redraw/simd/simd_columns.h"
#include "redraw/simd/simd_crossings.h"
#include "redraw/simd/simd_segments.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// v·S v at the vertices of a cluster, in the places of the forms. Places that are left over repeat
/// the last vertex, as in the forms.
static inline void evaluate_radial(const ClusterInSlot& place, const float eye[4], float* values) {
    const unsigned count = place.cluster.vertex_count;
    const Vectors e = {Floats{} + eye[0], Floats{} + eye[1], Floats{} + eye[2]};
    for (unsigned i = 0; i < form_groups(place.cluster) * kFormGroup; i += kLanes) {
        const CurvatureColumns p(curvatures_of(place), i, count);
        const Tangents v = p.tangent(e - p.position * (Floats{} + eye[3]));
        store(values + i, dot(v, p.S(v)));
    }
}

// Where the eye looks along the normal, or along the surface, the derivative means nothing; it is
// kept within what these let it become.
constexpr float kLeastSquaredSine = 0.03f, kLeastCosine = 0.1f;

/// Which zeros are accepted, their opacities, and as gradients the vectors −v/(|v|³ sin² cos),
/// times `sign`, with which the slope of a segment becomes the derivative of the radial curvature
/// towards the eye over the cosine of the normal and v.
static inline void test_radial_zeros(const LineRules& rules, const ExtractionTask& task, float sign,
                                     CrossingMemory& m, std::size_t count) {
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Towards v = towards(task.eye, m, i);
        const Floats facing = load(m.lit + i);
        const Floats distance = square_root(v.squared), cosine = facing / distance;
        const Ints accepted = cosine >= rules.least_facing;
        Floats opacity = Floats{} + 1;
        if (rules.contour_clearance > 0) {
            const Floats near = facing * absolute(facing) / (2 * load(m.gradient + i));
            opacity = clamp01(2 * near / rules.contour_clearance - 1);
        }
        store(m.opacity + i, opacity);
        const Floats factor =
            -sign / (v.squared * distance * at_least(1 - cosine * cosine, kLeastSquaredSine) *
                     at_least(cosine, kLeastCosine));
        store(m.gx + i, v.x * factor);
        store(m.gy + i, v.y * factor);
        store(m.gz + i, v.z * factor);
        accept(accepted, m, i);
    }
    store_gradients(m, count);
}

/// See simd_kinds.h. With sign 1 where the radial curvature grows towards the eye, −1 where it
/// falls.
template <LineKind kind, int sign>
struct RadialZeros : FacingKind {
    static constexpr LineKind kKind = kind;
    static constexpr unsigned kForms = kCurvatures;
    static constexpr SegmentSlope kSlope = SegmentSlope::Along;

    static inline BelowBound find_signs(const ExtractionTask& task, const ClusterInSlot& place,
                                        const BelowBound&, float* values) {
        float* own = in_slot(values, place);
        evaluate_radial(place, task.eye, own);
        return below(own, form_groups(place.cluster), 0);
    }

    static inline const float* source(const ExtractionTask& task) { return task.eye; }

    static inline void test(const LineRules& rules, const ExtractionTask& task, const Batch&,
                            CrossingMemory& m, std::size_t count) {
        test_radial_zeros(rules, task, sign, m, count);
    }
};

using SuggestiveContours = RadialZeros<LineKind::SuggestiveContour, 1>;
using SuggestiveHighlights = RadialZeros<LineKind::SuggestiveHighlight, -1>;

}  // namespace SIMD_SET
}  // namespace laplacian_lines
