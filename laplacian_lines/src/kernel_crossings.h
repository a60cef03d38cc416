// SPDX-License-Identifier: GPL-3.0-or-later
// Zero crossings on edges and their tests: L. Zhang, Y. He, H. S. Seah, "Laplacian Lines for
// Real-Time Shape Illustration", step 2 of the extraction.
// Included once by each of the files cluster_kernels_*.cpp.
#pragma once

#include <cfloat>

#include "cluster_kernels.h"
#include "kernel_vectors.h"

namespace laplacian_lines {
namespace KERNEL_NAMESPACE {

static inline float absolute(float v) {
    return __builtin_fabsf(v);
}
/// 0 for NaN.
static inline float clamp01(float v) {
    return v > 0 ? (v < 1 ? v : 1) : 0;
}
static inline float interpolate(float share, float below, float above) {
    return (1 - share) * below + share * above;
}

/// Where crossings [0, count) are on their edges, from the values at the ends.
static inline void find_shares(const float* values, CrossingMemory& m, std::size_t count) {
    count = whole_vectors(count);
    for (std::size_t i = 0; i < count; ++i) {
        m.below[i] = values[m.ends[i][0]];
        m.above[i] = values[m.ends[i][1]];
    }
    for (std::size_t i = 0; i < count; ++i) {
        const float below = absolute(m.below[i]), sum = below + absolute(m.above[i]);
        const float share = below / sum;  // sum > 0: one side is negative
        m.share[i] = sum <= FLT_MAX ? share : 0.5f;
    }
}

static inline void interpolate_values(const float* values, CrossingMemory& m, std::size_t count,
                                      float* result) {
    count = whole_vectors(count);
    for (std::size_t i = 0; i < count; ++i) {
        m.below[i] = values[m.ends[i][0]];
        m.above[i] = values[m.ends[i][1]];
    }
    for (std::size_t i = 0; i < count; ++i)
        result[i] = interpolate(m.share[i], m.below[i], m.above[i]);
}

/// ∇I = S l of a vertex.
static inline Float4 vertex_gradient(const VertexRecord& record, Float4 position, Float4 light,
                                     Float4 w) {
    const Float4 l = light - w * position;
    return load4(record.shape_operator[0]) * splat<0>(l) +
           load4(record.shape_operator[1]) * splat<1>(l) +
           load4(record.shape_operator[2]) * splat<2>(l);
}

/// Positions and gradients of crossings [0, count), as rows and as columns.
static inline void find_points(const VertexRecord* records, const float eye_of_light[4],
                               CrossingMemory& m, std::size_t count) {
    const Float4 light = {eye_of_light[0], eye_of_light[1], eye_of_light[2], 0};
    const Float4 w = splat(eye_of_light[3]);
    for (std::size_t i = 0; i < count; i += 4) {
        Float4 points[4], gradients[4];
        for (unsigned k = 0; k < 4; ++k) {
            const VertexRecord &a = records[m.ends[i + k][0]], &b = records[m.ends[i + k][1]];
            const Float4 pa = load4(a.position), pb = load4(b.position);
            const Float4 t = splat(m.share[i + k]), s = splat(1.f) - t;
            points[k] = s * pa + t * pb;
            gradients[k] =
                s * vertex_gradient(a, pa, light, w) + t * vertex_gradient(b, pb, light, w);
            store4(m.points[i + k], points[k]);
            store4(m.gradients[i + k], gradients[k]);
        }
        transpose(points);
        transpose(gradients);
        store_columns(points, m.x + i, m.y + i, m.z + i);
        store_columns(gradients, m.gx + i, m.gy + i, m.gz + i);
    }
    count = whole_vectors(count);
    for (std::size_t i = 0; i < count; ++i)
        m.gradient[i] = __builtin_sqrtf(m.gx[i] * m.gx[i] + m.gy[i] * m.gy[i] + m.gz[i] * m.gz[i]);
}

/// Refuses crossings with a gradient or facing below the thresholds.
static inline void apply_thresholds(const LineRules& rules, const float eye[4], CrossingMemory& m,
                                    std::size_t count) {
    count = whole_vectors(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float x = eye[0] - eye[3] * m.x[i], y = eye[1] - eye[3] * m.y[i],
                    z = eye[2] - eye[3] * m.z[i];
        const float distance = __builtin_sqrtf(x * x + y * y + z * z);
        const float steep = m.gradient[i] >= rules.least_gradient ? 1.f : -1.f;
        m.opacity[i] = m.facing[i] >= rules.least_facing * distance ? steep : -1.f;
    }
}

/// Fades crossings that would double a contour. To first order the contour is I/‖∇I‖ away on the
/// surface, which is seen at half the crossing's cosine on the way there.
static inline void fade_near_contours(float clearance, CrossingMemory& m, std::size_t count) {
    count = whole_vectors(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float distance = m.facing[i] * absolute(m.facing[i]) / (2 * m.gradient[i]);
        const float faded = m.opacity[i] * clamp01(2 * distance / clearance - 1);
        m.opacity[i] = m.opacity[i] < 0 ? -1.f : faded;
    }
}

/// Refuses crossings where the surface is convex and fades in from there. The measure is the cosine
/// between −∇I and the tangential part w of the light vector l: −l·Sl/(‖w‖‖Sl‖), with ∇I = Sl.
/// `lit` is n·l.
static inline void keep_concave(float fading, const float light[4], const float* lit,
                                CrossingMemory& m, std::size_t count) {
    const float least = -fading / 4, range = fading / 2 - least;
    count = whole_vectors(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float x = light[0] - light[3] * m.x[i], y = light[1] - light[3] * m.y[i],
                    z = light[2] - light[3] * m.z[i];
        const float squared = x * x + y * y + z * z - lit[i] * lit[i];
        const float tangential = __builtin_sqrtf(squared > 0 ? squared : 0);
        const float product = x * m.gx[i] + y * m.gy[i] + z * m.gz[i];
        const float concavity = -product / (tangential * m.gradient[i]);
        const float faded = range > 0 ? clamp01((concavity - least) / range) : 1.f;
        // Not so for NaN, too: nothing to see from above.
        const float before = m.opacity[i], after = before < 0 ? -1.f : before * faded;
        m.opacity[i] = concavity > least ? after : -1.f;
    }
}

/// Computes crossings [0, count) of one function from their ends. As all functions above, it
/// writes to whole vectors of places.
static inline void find_crossings(const VertexRecord* records, const ExtractionTask& task,
                                  const SignedCluster& signs, StripKind kind, CrossingMemory& m,
                                  std::size_t count) {
    for (std::size_t i = count; i < count + kLanes; ++i)  // something valid
        m.ends[i][0] = m.ends[i][1] = 0;
    find_shares(signs.values[kind], m, count);
    find_points(records, task.light, m, count);
    if (kind == kContourStrips) {
        count = whole_vectors(count);
        for (std::size_t i = 0; i < count; ++i)
            m.opacity[i] = 1;
        return;
    }
    const LineRules& rules = task.rules[kind];
    interpolate_values(signs.values[kContourStrips], m, count, m.facing);
    apply_thresholds(rules, task.eye, m, count);
    if (rules.contour_clearance > 0) fade_near_contours(rules.contour_clearance, m, count);
    if (!rules.concave_only) return;
    if (!task.light_at_eye) interpolate_values(signs.lit, m, count, m.lit);
    keep_concave(rules.fading, task.light, task.light_at_eye ? m.facing : m.lit, m, count);
}

}  // namespace KERNEL_NAMESPACE
}  // namespace laplacian_lines
