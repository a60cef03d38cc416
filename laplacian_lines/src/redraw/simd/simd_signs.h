// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of functions at the vertices of a cluster.
#pragma once

#include <cstdint>

#include "redraw/simd/redraw_loops.h"
#include "system/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_SET {

using Vectors = SpaceVectors<Floats>;

/// Bit i: values[i] < bound, for kFormGroup values.
static inline unsigned mask_below(const float* values, float bound) {
    unsigned mask = 0;
    for (unsigned i = 0; i < kFormGroup; i += kLanes)
        mask |= bits_of(load(values + i) < bound) << i;
    return mask;
}

/// A bit for each vertex of a cluster.
struct alignas(16) VertexBits {
    std::uint64_t words[2];
};

/// Up to kSignSets bits for each vertex of a cluster, for CornerLookup.
constexpr unsigned kSignSets = 2 * kMostKindsOfPass;
static_assert(kSignSets <= 8, "a bit of a byte each");
class VertexSigns {
public:
    void set(unsigned which, const VertexBits& bits);

private:
    friend class CornerLookup;
#if defined(__AVX2__)
    VertexBits sets_[kSignSets] = {};
#else
    alignas(16) std::uint8_t bits_[kClusterVertices] = {};  // bit `which` of each vertex's byte
#endif
};

/// Looks up bits of vertices for one corner of kMaskGroup triangles.
class CornerLookup {
public:
    CornerLookup(const unsigned char* corners, const VertexSigns& signs);
    /// Bit i: bit `which` of triangle i's vertex.
    std::uint64_t operator()(unsigned which) const;

private:
#if defined(__AVX2__)
    const VertexSigns& signs_;
    __m256i byte_[2], bit_[2];
#else
    alignas(16) std::uint8_t found_[kMaskGroup];
#endif
};

// The 128 bits are a table of 16 bytes: byte v / 8 is looked up by a shuffle, and bit v % 8 by
// another one in a table of single bits. Without such shuffles, all bits of a vertex are looked up
// at once.
#if defined(__AVX2__)
inline void VertexSigns::set(unsigned which, const VertexBits& bits) {
    sets_[which] = bits;
}
inline CornerLookup::CornerLookup(const unsigned char* corners, const VertexSigns& signs)
    : signs_(signs) {
    for (int half = 0; half < 2; ++half) {
        const __m256i v = _mm256_load_si256(reinterpret_cast<const __m256i*>(corners + 32 * half));
        byte_[half] = _mm256_and_si256(_mm256_srli_epi16(v, 3), _mm256_set1_epi8(15));
        bit_[half] = _mm256_shuffle_epi8(_mm256_set1_epi64x(std::int64_t(0x8040201008040201)), v);
    }
}
inline std::uint64_t CornerLookup::operator()(unsigned which) const {
    const __m256i table = _mm256_broadcastsi128_si256(
        _mm_load_si128(reinterpret_cast<const __m128i*>(&signs_.sets_[which])));
    std::uint32_t halves[2];
    for (int half = 0; half < 2; ++half) {
        const __m256i found = _mm256_and_si256(_mm256_shuffle_epi8(table, byte_[half]), bit_[half]);
        halves[half] = std::uint32_t(_mm256_movemask_epi8(_mm256_cmpeq_epi8(found, bit_[half])));
    }
    return halves[0] | std::uint64_t(halves[1]) << 32;
}
#else
inline void VertexSigns::set(unsigned which, const VertexBits& bits) {
    constexpr std::uint64_t ones = 0x0101010101010101;
    for (unsigned i = 0; i < kClusterVertices; i += 8) {
        // Bit k of eight to byte k: copies of them all, one bit of each, and that to the lowest.
        const std::uint64_t copies = (bits.words[i / 64] >> i % 64 & 0xff) * ones;
        const std::uint64_t single = copies & 0x8040201008040201;
        const std::uint64_t lowest = (single + 0x7f7f7f7f7f7f7f7f) >> 7 & ones;
        std::uint64_t all;
        __builtin_memcpy(&all, bits_ + i, 8);
        all |= lowest << which;
        __builtin_memcpy(bits_ + i, &all, 8);
    }
}
inline CornerLookup::CornerLookup(const unsigned char* corners, const VertexSigns& signs) {
    for (unsigned i = 0; i < kMaskGroup; ++i)
        found_[i] = signs.bits_[corners[i]];
}
inline std::uint64_t CornerLookup::operator()(unsigned which) const {
    constexpr std::uint64_t ones = 0x0101010101010101;
    std::uint64_t mask = 0;
    for (unsigned i = 0; i < kMaskGroup; i += 8) {
        std::uint64_t eight;
        __builtin_memcpy(&eight, found_ + i, 8);
        mask |= ((eight >> which & ones) * 0x0102040810204080 >> 56) << i;  // byte k's bit to bit k
    }
    return mask;
}
#endif

/// Linear forms v·(e − w p) of all vertices.
static inline void evaluate_forms(const FormGroup* forms, unsigned groups, const float eye[4],
                                  float* values) {
    const float ex = eye[0], ey = eye[1], ez = eye[2], w = eye[3];
    for (unsigned g = 0; g < groups; ++g, ++forms, values += kFormGroup)
        for (unsigned i = 0; i < kFormGroup; i += kLanes)
            store(values + i, load(forms->numbers[0] + i) * ex + load(forms->numbers[1] + i) * ey +
                                  load(forms->numbers[2] + i) * ez -
                                  w * load(forms->numbers[3] + i));
}

/// Which of a cluster's values are below a bound, and whether any or all are.
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

}  // namespace SIMD_SET
}  // namespace laplacian_lines
