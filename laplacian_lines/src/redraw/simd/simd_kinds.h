// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of lines that are zeros of functions of the vertices, each a type of static members:
//  - kKind; kForms: a bit for each VertexForm that it reads, and kCurvatures,
//  - kIsFacing: the function is n·eye; else evaluate(task, place, values) writes its values at the
//    vertices of a cluster, in the places of the forms, and nothing is wanted of triangles with
//    n·eye below ExtractionTask's bound at all corners,
//  - unwanted(rules, cluster, group): a bit for each triangle of the group that holds no line,
//  - source(task): the eye or light l whose S l is the gradient at a crossing,
//  - test(rules, task, batch, crossings, count): opacities of crossings; if the rules use slopes,
//    also which are accepted and, unless kSlope is Scaled, the vectors d of SegmentSlope in place
//    of the gradients,
//  - kSlope: what a segment's slope is.
#pragma once

#include "redraw/simd/simd_crossings.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// Beside the bits of VertexForm: the CurvatureRecords of all vertices are read to find signs.
constexpr unsigned kCurvatures = 1u << kVertexFormCount;

/// Occluding contours: the zeros of n·(e − w p).
struct Contours {
    static constexpr LineKind kKind = LineKind::Contour;
    static constexpr unsigned kForms = 1u << kFacingForm;
    static constexpr SegmentSlope kSlope = SegmentSlope::Scaled;
    static constexpr bool kIsFacing = true;

    static inline std::uint64_t unwanted(const LineRules&, const Cluster&, unsigned) { return 0; }

    static inline const float* source(const ExtractionTask& task) { return task.eye; }

    /// Opacities are 1, less where the surface is concave along the view.
    static inline void test(const LineRules& rules, const ExtractionTask& task, const Batch&,
                            CrossingMemory& m, std::size_t count) {
        for (std::size_t i = 0; i < count; i += kLanes) {
            const Vectors v = towards(task.eye, m, i);
            const Floats product = dot(v, load_vectors(m.g, i)), distance = square_root(dot(v, v));
            const Floats gradient = load(m.gradient + i) + LineRules::kFlat * distance;
            const Floats concavity = -product / (distance * gradient);
            store(m.opacity + i, 1 - clamp01(concavity / rules.concave_thinning));  // 1 for NaN
        }
    }
};

/// What kinds of lines share that are drawn on what faces the eye.
struct OnFacingSurface {
    static constexpr bool kIsFacing = false;

    static inline std::uint64_t unwanted(const LineRules& rules, const Cluster& cluster,
                                         unsigned group) {
        const std::uint64_t* convex =
            is_cut_by_convex(rules) ? cluster.convex : cluster.convex_around;
        return (rules.leave_out_convex ? convex[group] : 0) |
               (rules.drop_featureless ? cluster.featureless[group] : 0);
    }
};

/// Opacities of crossings that would double a contour nearby, as clearance_opacity() of
/// rules/thresholds.h computes them. To first order the contour is I/‖∇I‖ away, I = facing, on
/// the surface, which is seen at half the crossing's cosine on the way there.
static inline Floats opacity_beside_contours(const LineRules& rules, Floats facing,
                                             Floats gradient) {
    if (!(rules.contour_clearance > 0)) return Floats{} + 1;
    const Floats distance = facing * absolute(facing) / (2 * gradient);
    return clamp01(2 * distance / rules.contour_clearance - 1);
}

/// How the surface curves towards the light vector l at crossings [i, i + kLanes): −l·Sl, and ‖w‖
/// of l's tangential part w. The cosine between −∇I and w is −l·Sl/(‖w‖‖∇I‖), since ∇I = Sl.
struct Concavity {
    Floats product, tangential;
};
static inline Concavity concavity_towards(const Vectors& light, const CrossingMemory& m,
                                          std::size_t i) {
    const Floats lit = load(m.lit + i);
    return {-dot(light, load_vectors(m.g, i)),
            square_root(at_least(dot(light, light) - lit * lit, 0))};
}

/// Which crossings of ΔI are accepted, and their opacities: thresholds on gradient and facing,
/// fading near contours, and concavity. `facings`: n·eye. Of whole lines facing decides, and what
/// is clearly convex goes.
static inline void test_laplacian_crossings(const LineRules& rules, const ExtractionTask& task,
                                            const float* facings, CrossingMemory& m,
                                            std::size_t count) {
    const float least = -rules.fading / 4, range = rules.fading / 2 - least;
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Floats facing = load(facings + i), gradient = load(m.gradient + i);
        const Vectors eye = towards(task.eye, m, i);
        Ints accepted = facing >= rules.least_facing * square_root(dot(eye, eye));
        Floats opacity = opacity_beside_contours(rules, facing, gradient);
        if (rules.concave_only) {
            const Concavity concave =
                concavity_towards(task.light_at_eye ? eye : towards(task.light, m, i), m, i);
            if (rules.whole) {
                const Floats part = concave.product / concave.tangential;
                const Floats most = part < gradient ? part : gradient;
                const Floats clamped = part > -gradient ? most : -gradient;  // -gradient for NaN
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

/// Laplacian lines: the zeros of ΔI = Δn·l.
struct LaplacianLines : OnFacingSurface {
    static constexpr LineKind kKind = LineKind::Laplacian;
    static constexpr unsigned kForms = 1u << kLaplacianForm;
    static constexpr SegmentSlope kSlope = SegmentSlope::Scaled;

    static inline void evaluate(const ExtractionTask& task, const ClusterInSlot& place,
                                float* values) {
        evaluate_forms(place.laplacians, form_groups(place.cluster), task.light, values);
    }

    static inline const float* source(const ExtractionTask& task) { return task.light; }

    static inline void test(const LineRules& rules, const ExtractionTask& task, const Batch& batch,
                            CrossingMemory& m, std::size_t count) {
        if (!task.light_at_eye) find_facing(batch, task.eye, m, count);
        test_laplacian_crossings(rules, task, task.light_at_eye ? m.lit : m.facing, m, count);
    }
};

/// Writes function(p, v) of vertices p and the vectors v to an eye or light at the vertices of a
/// cluster, in the places of the forms. Places that are left over repeat the last vertex, as in the
/// forms.
template <class Function>
static inline void evaluate_curvatures(const ClusterInSlot& place, const float eye[4],
                                       float* values, const Function& function) {
    const Vectors e = {Floats{} + eye[0], Floats{} + eye[1], Floats{} + eye[2]};
    for (unsigned i = 0; i < form_groups(place.cluster) * kFormGroup; i += kLanes) {
        const CurvatureColumns p(curvatures_of(place), i, place.cluster.vertex_count);
        store(values + i, function(p, e - p.position * (Floats{} + eye[3])));
    }
}

/// Photic extremum lines: the zeros of Hess I(g, g), g = ∇I, where ‖g‖ is largest along g.
struct PhoticExtrema : OnFacingSurface {
    static constexpr LineKind kKind = LineKind::PhoticExtremum;
    static constexpr unsigned kForms = kCurvatures;
    static constexpr SegmentSlope kSlope = SegmentSlope::AlongOnce;

    /// C(g, g, l) − (n·l) ‖S g‖² − w g·S g
    static inline void evaluate(const ExtractionTask& task, const ClusterInSlot& place,
                                float* values) {
        const float w = task.light[3];
        evaluate_curvatures(
            place, task.light, values, [&](const CurvatureColumns& p, const Vectors& light) {
                const Tangents l = p.tangent(light), g = p.S(l), sg = p.S(g);
                return p.C(g, g, l) - dot(p.normal, light) * dot(sg, sg) - w * dot(g, sg);
            });
    }

    static inline const float* source(const ExtractionTask& task) { return task.light; }

    /// Makes the gradients g of crossings g/‖g‖³, with which −∇f·d becomes minus the second
    /// derivative of ‖g‖ along g.
    static inline void test(const LineRules& rules, const ExtractionTask& task, const Batch& batch,
                            CrossingMemory& m, std::size_t count) {
        LaplacianLines::test(rules, task, batch, m, count);
        for (std::size_t i = 0; i < count; i += kLanes) {
            const Floats g = load(m.gradient + i), factor = 1 / (g * g * g);
            store_vectors(load_vectors(m.g, i) * factor, m.g, i);
        }
    }
};

/// Suggestive contours and highlights: the zeros of the radial curvature, of which v·S v with the
/// vector to the eye v is a positive multiple; with sign 1 where it grows towards the eye, −1 where
/// it falls.
template <LineKind kind, int sign>
struct RadialZeros : OnFacingSurface {
    static constexpr LineKind kKind = kind;
    static constexpr unsigned kForms = kCurvatures;
    static constexpr SegmentSlope kSlope = SegmentSlope::Along;
    // Least divisors: where the eye looks along the normal, or along the surface, the derivative
    // means nothing and would grow without bound.
    static constexpr float kLeastSquaredSine = 0.03f, kLeastCosine = 0.1f;

    static inline void evaluate(const ExtractionTask& task, const ClusterInSlot& place,
                                float* values) {
        evaluate_curvatures(place, task.eye, values,
                            [](const CurvatureColumns& p, const Vectors& eye) {
                                const Tangents v = p.tangent(eye);
                                return dot(v, p.S(v));
                            });
    }

    static inline const float* source(const ExtractionTask& task) { return task.eye; }

    /// Makes the gradients the vectors d = −sign v/(|v|³ sin² cos), with which −∇f·d becomes sign
    /// times the derivative of the radial curvature towards the eye, over the cosine of the normal
    /// and v.
    static inline void test(const LineRules& rules, const ExtractionTask& task, const Batch&,
                            CrossingMemory& m, std::size_t count) {
        for (std::size_t i = 0; i < count; i += kLanes) {
            const Vectors v = towards(task.eye, m, i);
            const Floats facing = load(m.lit + i), squared = dot(v, v);
            const Floats distance = square_root(squared), cosine = facing / distance;
            store(m.opacity + i, opacity_beside_contours(rules, facing, load(m.gradient + i)));
            const Floats factor = -float(sign) / (squared * distance *
                                                  at_least(1 - cosine * cosine, kLeastSquaredSine) *
                                                  at_least(cosine, kLeastCosine));
            store_vectors(v * factor, m.g, i);
            accept(cosine >= rules.least_facing, m, i);
        }
    }
};

using SuggestiveContours = RadialZeros<LineKind::SuggestiveContour, 1>;
using SuggestiveHighlights = RadialZeros<LineKind::SuggestiveHighlight, -1>;

/// The function's values in the whole batch, by the kind's place in the pass.
template <class Kind>
static inline const float* values_of(const Batch& batch, unsigned number) {
    return Kind::kIsFacing ? batch.facing : batch.values[number];
}

/// The kinds of a pass.
template <unsigned Pass, class... Kinds>
struct KindList {
    static constexpr unsigned kFirst = kStripPasses[Pass].first;  ///< in kStripKinds
    static constexpr unsigned kCount = sizeof...(Kinds);
    static constexpr bool kReadsCurvatures = ((Kinds::kForms | ...) & kCurvatures) != 0;

    static constexpr bool is_as_declared() {
        unsigned number = kFirst;
        return kCount == kStripPasses[Pass].count && kCount <= kMostKindsOfPass &&
               ((Kinds::kKind == kStripKinds[number++]) && ...);
    }

    /// Calls visit(kind, number) for each kind with its place in the pass.
    template <class Visit>
    static inline void for_each(const Visit& visit) {
        unsigned number = 0;
        (visit(Kinds{}, number++), ...);
    }
};

using StandardKinds = KindList<0, LaplacianLines, Contours>;
using SuggestiveKinds = KindList<1, SuggestiveContours, SuggestiveHighlights>;
using PhoticKinds = KindList<2, PhoticExtrema>;
static_assert(StandardKinds::is_as_declared() && SuggestiveKinds::is_as_declared() &&
                  PhoticKinds::is_as_declared(),
              "the same kinds in the same order");

}  // namespace SIMD_SET
}  // namespace laplacian_lines
