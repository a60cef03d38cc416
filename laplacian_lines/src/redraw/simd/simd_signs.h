// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of functions at the vertices of a cluster.
// Included once by each of the files simd_*.cpp.
#pragma once

#include <cstdint>

#include "redraw/simd/simd_memory.h"
#include "redraw/simd/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_NAMESPACE {

/// Linear forms v·(e − w p) of all vertices.
static inline void evaluate(const FormGroup* forms, unsigned groups, const float eye[4],
                            float* values) {
    const float ex = eye[0], ey = eye[1], ez = eye[2], w = eye[3];
    for (unsigned g = 0; g < groups; ++g, ++forms, values += kFormGroup)
        for (unsigned i = 0; i < kFormGroup; i += kLanes)
            store(values + i, load(forms->numbers[0] + i) * ex + load(forms->numbers[1] + i) * ey +
                                  load(forms->numbers[2] + i) * ez -
                                  w * load(forms->numbers[3] + i));
}

/// How many of a cluster's values are below a bound, and which.
struct BelowBound {
    VertexBits bits{{0, 0}};
    bool any = false, all = false;
};

static inline BelowBound below(const float* values, unsigned groups, float bound) {
    BelowBound result;
    unsigned any = 0, all = 0xffff;
    for (unsigned g = 0; g < groups; ++g) {
        const unsigned mask = mask_below(values + g * kFormGroup, bound);
        result.bits.words[g / 4] |= std::uint64_t(mask) << g % 4 * kFormGroup;
        any |= mask;
        all &= mask;
    }
    result.any = any != 0;
    result.all = all == 0xffff;
    return result;
}

/// A cluster in its slot of a batch.
struct ClusterInSlot {
    const Cluster& cluster;
    ClusterLayout layout;
    const unsigned char* memory;
    const FormGroup* laplacians;
    const CurvatureRecord* curvatures;  ///< the store's
    unsigned slot;
};
static inline const FormGroup* facing_of(const ClusterInSlot& place) {
    return reinterpret_cast<const FormGroup*>(place.memory);
}
static inline ClusterTriangles triangles_of(const ClusterInSlot& place) {
    return {place.memory + place.layout.corners, place.memory + place.layout.neighbours};
}
static inline const CurvatureRecord* curvatures_of(const ClusterInSlot& place) {
    return place.curvatures + place.cluster.first_vertex;
}
/// Its part of one of Batch's arrays.
static inline float* in_slot(float* values, const ClusterInSlot& place) {
    return values + place.slot * kClusterVertices;
}

}  // namespace SIMD_NAMESPACE
}  // namespace laplacian_lines
