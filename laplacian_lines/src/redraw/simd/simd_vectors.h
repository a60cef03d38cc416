// SPDX-License-Identifier: GPL-3.0-or-later
// Included once by each of the files simd_*.cpp, which name the namespace.
#pragma once

#include <cstddef>
#include <cstdint>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "clusters/cluster_data.h"
#include "redraw/extraction_task.h"

namespace laplacian_lines {
namespace SIMD_NAMESPACE {

#if defined(__AVX512F__)
constexpr unsigned kLanes = 16;
#elif defined(__AVX__)
constexpr unsigned kLanes = 8;
#else
constexpr unsigned kLanes = 4;
#endif

/// `count` rounded up to whole vectors: loops over so many places need no code for a rest, which
/// would run more often than that for whole vectors, since clusters hold short lists.
static inline std::size_t whole_vectors(std::size_t count) {
    return (count + kLanes - 1) & ~std::size_t(kLanes - 1);
}

// ---- whole vectors ----
// Loops are written with these, since compilers vectorize the plain ones only if nothing in them is
// in their way, and tell nobody.

typedef float Floats __attribute__((vector_size(4 * kLanes)));
typedef std::int32_t Ints __attribute__((vector_size(4 * kLanes)));  ///< masks: 0 or -1

typedef double Doubles __attribute__((vector_size(8 * kLanes)));

static inline Floats load(const float* p) {  // aligned
    return *reinterpret_cast<const Floats*>(p);
}
static inline Floats load_anywhere(const float* p) {
    Floats v;
    __builtin_memcpy(&v, p, sizeof v);
    return v;
}
static inline void store(float* p, Floats v) {  // aligned
    *reinterpret_cast<Floats*>(p) = v;
}
static inline Floats square_root(Floats v) {
#if defined(__AVX512F__)
    return _mm512_sqrt_ps(v);
#elif defined(__AVX__)
    return _mm256_sqrt_ps(v);
#elif defined(__SSE2__)
    return _mm_sqrt_ps(v);
#else
    for (unsigned i = 0; i < kLanes; ++i)
        v[i] = __builtin_sqrtf(v[i]);
    return v;
#endif
}
static inline Floats absolute(Floats v) {
    return (Floats)((Ints)v & 0x7fffffff);
}
/// The bound for NaN.
static inline Floats at_least(Floats v, float bound) {
    return v > bound ? v : Floats{} + bound;
}
static inline Floats at_most(Floats v, float bound) {
    return v < bound ? v : Floats{} + bound;
}
/// 0 for NaN.
static inline Floats clamp01(Floats v) {
    return at_most(at_least(v, 0), 1);
}
/// Bit i: mask of lane i.
static inline unsigned bits_of(Ints mask) {
#if defined(__AVX512DQ__)
    return _mm512_movepi32_mask((__m512i)mask);
#elif defined(__AVX__)
    return unsigned(_mm256_movemask_ps((__m256)mask));
#elif defined(__SSE2__)
    return unsigned(_mm_movemask_ps((__m128)mask));
#else
    unsigned bits = 0;
    for (unsigned i = 0; i < kLanes; ++i)
        bits |= unsigned(mask[i] != 0) << i;
    return bits;
#endif
}

// ---- rows of four numbers ----

typedef float Float4 __attribute__((vector_size(16)));

static inline Float4 load4(const float* p) {
    return *reinterpret_cast<const Float4*>(p);
}
static inline void store4(float* p, Float4 v) {
    *reinterpret_cast<Float4*>(p) = v;
}
static inline Float4 splat(float v) {
    return Float4{v, v, v, v};
}
static inline Float4 square_root4(Float4 v) {
#if defined(__SSE2__)
    return _mm_sqrt_ps(v);
#else
    return Float4{__builtin_sqrtf(v[0]), __builtin_sqrtf(v[1]), __builtin_sqrtf(v[2]),
                  __builtin_sqrtf(v[3])};
#endif
}

/// Places A, B, C and D of eight: those of a, then those of b.
template <int A, int B, int C, int D>
static inline Float4 shuffle(Float4 a, Float4 b) {
#if defined(__clang__)
    return __builtin_shufflevector(a, b, A, B, C, D);
#else
    typedef std::int32_t Int4 __attribute__((vector_size(16)));
    return __builtin_shuffle(a, b, Int4{A, B, C, D});
#endif
}
template <int K>
static inline Float4 splat(Float4 v) {
    return shuffle<K, K, K, K>(v, v);
}

/// Four rows to columns.
static inline void transpose(Float4 rows[4]) {
    const Float4 a = shuffle<0, 4, 1, 5>(rows[0], rows[1]);
    const Float4 b = shuffle<0, 4, 1, 5>(rows[2], rows[3]);
    const Float4 c = shuffle<2, 6, 3, 7>(rows[0], rows[1]);
    const Float4 d = shuffle<2, 6, 3, 7>(rows[2], rows[3]);
    rows[0] = shuffle<0, 1, 4, 5>(a, b);
    rows[1] = shuffle<2, 3, 6, 7>(a, b);
    rows[2] = shuffle<0, 1, 4, 5>(c, d);
    rows[3] = shuffle<2, 3, 6, 7>(c, d);
}

/// A whole vector is kParts parts of four places.
constexpr unsigned kParts = kLanes / 4;
static inline Floats join(const Float4 parts[kParts]) {
#if defined(__AVX512F__)
    const __m512 low = _mm512_insertf32x4(_mm512_castps128_ps512(parts[0]), parts[1], 1);
    return _mm512_insertf32x4(_mm512_insertf32x4(low, parts[2], 2), parts[3], 3);
#elif defined(__AVX__)
    return _mm256_set_m128(parts[1], parts[0]);
#else
    return parts[0];
#endif
}
static inline void split(Floats v, Float4 parts[kParts]) {
#if defined(__AVX512F__)
    parts[0] = _mm512_castps512_ps128(v);
    parts[1] = _mm512_extractf32x4_ps(v, 1);
    parts[2] = _mm512_extractf32x4_ps(v, 2);
    parts[3] = _mm512_extractf32x4_ps(v, 3);
#elif defined(__AVX__)
    parts[0] = _mm256_castps256_ps128(v);
    parts[1] = _mm256_extractf128_ps(v, 1);
#else
    parts[0] = v;
#endif
}

/// Four rows to columns, each part for itself.
static inline void transpose_parts(Floats rows[4]) {
#if defined(__AVX512F__)
    constexpr __mmask16 all = 0xffff;  // without a mask, GCC 12 warns of its own header
    const __m512 a = _mm512_maskz_unpacklo_ps(all, rows[0], rows[1]);
    const __m512 b = _mm512_maskz_unpacklo_ps(all, rows[2], rows[3]);
    const __m512 c = _mm512_maskz_unpackhi_ps(all, rows[0], rows[1]);
    const __m512 d = _mm512_maskz_unpackhi_ps(all, rows[2], rows[3]);
    rows[0] = _mm512_shuffle_ps(a, b, 0x44);
    rows[1] = _mm512_shuffle_ps(a, b, 0xee);
    rows[2] = _mm512_shuffle_ps(c, d, 0x44);
    rows[3] = _mm512_shuffle_ps(c, d, 0xee);
#elif defined(__AVX__)
    const __m256 a = _mm256_unpacklo_ps(rows[0], rows[1]), b = _mm256_unpacklo_ps(rows[2], rows[3]);
    const __m256 c = _mm256_unpackhi_ps(rows[0], rows[1]), d = _mm256_unpackhi_ps(rows[2], rows[3]);
    rows[0] = _mm256_shuffle_ps(a, b, 0x44);
    rows[1] = _mm256_shuffle_ps(a, b, 0xee);
    rows[2] = _mm256_shuffle_ps(c, d, 0x44);
    rows[3] = _mm256_shuffle_ps(c, d, 0xee);
#else
    transpose(rows);
#endif
}

static inline void store_row(Float4 row, float* p) {
    __builtin_memcpy(p, &row, sizeof(Float4));
}
static inline void store_columns(const Float4 columns[3], float* x, float* y, float* z) {
    __builtin_memcpy(x, &columns[0], sizeof(Float4));
    __builtin_memcpy(y, &columns[1], sizeof(Float4));
    __builtin_memcpy(z, &columns[2], sizeof(Float4));
}

// ---- signs ----

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
#if defined(__AVX512BW__)
    const VertexSigns& signs_;
    __m512i byte_, bit_;
#elif defined(__AVX2__)
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
#endif
#if defined(__AVX512BW__)
inline CornerLookup::CornerLookup(const unsigned char* corners, const VertexSigns& signs)
    : signs_(signs) {
    const __m512i v = _mm512_load_si512(corners);
    byte_ = _mm512_and_si512(_mm512_srli_epi16(v, 3), _mm512_set1_epi8(15));
    bit_ = _mm512_shuffle_epi8(_mm512_set1_epi64(std::int64_t(0x8040201008040201)), v);
}
inline std::uint64_t CornerLookup::operator()(unsigned which) const {
    const __m512i table = _mm512_broadcast_i32x4(
        _mm_load_si128(reinterpret_cast<const __m128i*>(&signs_.sets_[which])));
    return _mm512_test_epi8_mask(_mm512_shuffle_epi8(table, byte_), bit_);
}
#elif defined(__AVX2__)
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
inline CornerLookup::CornerLookup(const unsigned char* corners, const VertexSigns& signs) {
    for (unsigned i = 0; i < kMaskGroup; ++i)
        found_[i] = signs.bits_[corners[i]];
}
inline std::uint64_t CornerLookup::operator()(unsigned which) const {
    std::uint64_t mask = 0;
#if defined(__SSE2__)
    for (unsigned i = 0; i < kMaskGroup; i += 16) {
        const __m128i found = _mm_load_si128(reinterpret_cast<const __m128i*>(found_ + i));
        const __m128i highest = _mm_sll_epi16(found, _mm_cvtsi32_si128(7 - int(which)));
        mask |= std::uint64_t(std::uint32_t(_mm_movemask_epi8(highest))) << i;
    }
#else
    for (unsigned i = 0; i < kMaskGroup; ++i)
        mask |= std::uint64_t(found_[i] >> which & 1) << i;
#endif
    return mask;
}
#endif

}  // namespace SIMD_NAMESPACE
}  // namespace laplacian_lines
