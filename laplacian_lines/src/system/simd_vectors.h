// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

/// See simd_sets.h.
namespace laplacian_lines {
namespace SIMD_SET {

#if defined(__AVX512F__)
constexpr unsigned kLanes = 16;
#elif defined(__AVX__)
constexpr unsigned kLanes = 8;
#else
constexpr unsigned kLanes = 4;
#endif

/// `count` rounded up to whole vectors: loops over so many elements need no code for a remainder,
/// which would dominate, since clusters hold short lists.
static inline std::size_t whole_vectors(std::size_t count) {
    return (count + kLanes - 1) & ~std::size_t(kLanes - 1);
}

// ---- whole vectors ----
// Loops are written with these, since automatic vectorization fails silently.

typedef float Floats __attribute__((vector_size(4 * kLanes)));
typedef std::int32_t Ints __attribute__((vector_size(4 * kLanes)));  ///< masks: 0 or -1

static inline Floats load(const float* p) {  // aligned
    return *reinterpret_cast<const Floats*>(p);
}
static inline void store(float* p, Floats v) {  // aligned
    *reinterpret_cast<Floats*>(p) = v;
}
/// Of vectors of floats.
template <class Vector>
static inline Vector square_root(Vector v) {
    float numbers[sizeof v / sizeof(float)];
    __builtin_memcpy(numbers, &v, sizeof v);
    for (float& number : numbers)
        number = __builtin_sqrtf(number);
    __builtin_memcpy(&v, numbers, sizeof v);
    return v;
}
static inline Floats absolute(Floats v) {
    return (Floats)((Ints)v & 0x7fffffff);
}
/// The bound for NaN, as in at_most().
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

/// A vector of space in each lane.
template <class Lanes>
struct SpaceVectors {
    Lanes x, y, z;

    SpaceVectors operator+(const SpaceVectors& b) const { return {x + b.x, y + b.y, z + b.z}; }
    SpaceVectors operator-(const SpaceVectors& b) const { return {x - b.x, y - b.y, z - b.z}; }
    SpaceVectors operator*(const Lanes& s) const { return {x * s, y * s, z * s}; }
};
template <class Lanes>
static inline Lanes dot(const SpaceVectors<Lanes>& a, const SpaceVectors<Lanes>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <std::size_t Count>
static inline SpaceVectors<Floats> load_vectors(const float (&p)[3][Count], std::size_t lane) {
    return {load(p[0] + lane), load(p[1] + lane), load(p[2] + lane)};
}
template <std::size_t Count>
static inline void store_vectors(const SpaceVectors<Floats>& v, float (&to)[3][Count],
                                 std::size_t lane) {
    store(to[0] + lane, v.x);
    store(to[1] + lane, v.y);
    store(to[2] + lane, v.z);
}

/// Sums over sources at all targets, of which there are `Count`, a vector of them at a time.
template <auto Sum, std::size_t Count, class Targets, class Source, class Sums>
static void at_all_lanes(const Targets& targets, const Source* sources, std::size_t count,
                         Sums& sums) {
    for (std::size_t lane = 0; lane < Count; lane += kLanes)
        Sum(targets, sources, count, lane, sums);
}

// ---- rows of four numbers ----

typedef float Float4 __attribute__((vector_size(16)));

static inline Float4 load4(const float* p) {  // aligned
    return *reinterpret_cast<const Float4*>(p);
}
static inline void store4(float* p, Float4 v) {  // aligned
    *reinterpret_cast<Float4*>(p) = v;
}
template <int A, int B, int C, int D, class Vector, std::size_t... Lanes>
static inline Vector shuffle(Vector a, Vector b, std::index_sequence<Lanes...>) {
    constexpr auto place = [](std::size_t lane) {
        constexpr int places[4] = {A, B, C, D};
        const int among_four = places[lane % 4], first = int(lane / 4 * 4);
        return first + among_four + (among_four < 4 ? 0 : int(sizeof...(Lanes)) - 4);
    };
#if defined(__clang__)
    return __builtin_shufflevector(a, b, place(Lanes)...);
#else
    typedef std::int32_t Places __attribute__((vector_size(sizeof(Vector))));
    return __builtin_shuffle(a, b, Places{place(Lanes)...});
#endif
}
/// In each group of four lanes, lanes A, B, C and D of eight: the group's lanes of a, then of b.
template <int A, int B, int C, int D, class Vector>
static inline Vector shuffle(Vector a, Vector b) {
    return shuffle<A, B, C, D>(a, b, std::make_index_sequence<sizeof a / sizeof a[0]>());
}

/// Transposes four rows in each group of four lanes.
template <class Vector>
static inline void transpose(Vector rows[4]) {
    const Vector a = shuffle<0, 4, 1, 5>(rows[0], rows[1]);
    const Vector b = shuffle<0, 4, 1, 5>(rows[2], rows[3]);
    const Vector c = shuffle<2, 6, 3, 7>(rows[0], rows[1]);
    const Vector d = shuffle<2, 6, 3, 7>(rows[2], rows[3]);
    rows[0] = shuffle<0, 1, 4, 5>(a, b);
    rows[1] = shuffle<2, 3, 6, 7>(a, b);
    rows[2] = shuffle<0, 1, 4, 5>(c, d);
    rows[3] = shuffle<2, 3, 6, 7>(c, d);
}

/// Groups of four lanes in a vector.
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
static inline void split(const Floats& v, Float4 parts[kParts]) {
    __builtin_memcpy(parts, &v, sizeof v);
}

static inline void store_row(Float4 row, float* p) {  // anywhere
    __builtin_memcpy(p, &row, sizeof(Float4));
}
static inline void store_columns(const Float4 columns[3], float* x, float* y, float* z) {
    store_row(columns[0], x);
    store_row(columns[1], y);
    store_row(columns[2], z);
}

}  // namespace SIMD_SET
}  // namespace laplacian_lines
