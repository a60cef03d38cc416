// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/simd/simd_apparent.h"
#include "system/simd_sets.h"

namespace laplacian_lines {
namespace SIMD_SET {

// ---- which triangles of a cluster the functions change their signs in ----

/// Places in write_active()'s bytes that make an ActiveTriangle, by which corners are negative.
/// A line leaves through the edge that goes from a negative to a positive corner.
struct alignas(16) ActivePattern {
    std::uint8_t places[16];
};
constexpr ActivePattern active_pattern(unsigned exit, bool third_is_negative) {
    const auto a = std::uint8_t(exit), b = std::uint8_t((exit + 1) % 3),
               c = std::uint8_t((exit + 2) % 3);
    const std::uint8_t entry = third_is_negative ? b : c;
    return {{a, b, c, 3, third_is_negative ? c : a, third_is_negative ? b : c, std::uint8_t(4 + a),
             std::uint8_t(4 + entry)}};
}
constexpr ActivePattern kActivePatterns[8] = {
    {},                        // none: no crossing
    active_pattern(0, false),  // the first corner alone
    active_pattern(1, false),  // the second
    active_pattern(1, true),   // the first and the second
    active_pattern(2, false),  // the third
    active_pattern(0, true),   // the third and the first
    active_pattern(2, true),   // the second and the third
    {},
};

typedef std::uint16_t Places __attribute__((vector_size(16)));  ///< ActiveTriangle
/// Writes triangle `number` of a cluster, from these bytes: corners, the number, neighbours.
static inline void write_active(const ClusterTriangles& triangles, unsigned number,
                                unsigned negative_corners, unsigned slot, ActiveTriangle& active) {
    constexpr std::uint16_t v = kClusterVertices, n = kNumbersOfSlot;
    const ActivePattern& pattern = kActivePatterns[negative_corners];
    const std::uint8_t* corners = triangles.corners + place_of_corners(number);
    const std::uint32_t first = corners[0] | std::uint32_t(corners[kMaskGroup]) << 8 |
                                std::uint32_t(corners[2 * kMaskGroup]) << 16 | number << 24;
    std::uint32_t neighbours;  // and a byte of what is behind
    __builtin_memcpy(&neighbours, triangles.neighbours + 3 * number, 4);
    Places numbers = {};
#if defined(__SSE4_1__)
    const __m128i bytes = _mm_insert_epi32(_mm_cvtsi32_si128(int(first)), int(neighbours), 1);
    const __m128i places = _mm_load_si128(reinterpret_cast<const __m128i*>(pattern.places));
    numbers = (Places)_mm_cvtepu8_epi16(_mm_shuffle_epi8(bytes, places));
#else
    unsigned char bytes[8];
    __builtin_memcpy(bytes, &first, 4);
    __builtin_memcpy(bytes + 4, &neighbours, 4);
    for (int i = 0; i < 8; ++i)
        numbers[i] = bytes[pattern.places[i]];
#endif
    numbers += Places{v, v, v, n, v, v, n, n} * std::uint16_t(slot);
    __builtin_memcpy(&active, &numbers, sizeof numbers);
}

/// Appends the triangles of a mask, which is for those from number `first` on, and asks for the
/// records of their crossings.
static inline void list_mixed(std::uint64_t mask, const std::uint64_t negative[3],
                              const ClusterInSlot& place, unsigned first, const Batch& batch,
                              ActiveTriangles& active) {
    const ClusterTriangles triangles = triangles_of(place);
    const RecordsOfSlot records = records_around(batch, place.slot * kClusterVertices);
    unsigned count = active.count;
    for (; mask; mask &= mask - 1) {
        const auto i = unsigned(__builtin_ctzll(mask));
        const auto corners = unsigned((negative[0] >> i & 1) | (negative[1] >> i & 1) << 1 |
                                      (negative[2] >> i & 1) << 2);
        ActiveTriangle& triangle = active.triangles[count++];
        write_active(triangles, first + i, corners, place.slot, triangle);
        __builtin_prefetch(position_at(records, triangle.exit[0]));
        __builtin_prefetch(position_at(records, triangle.exit[1]));
        __builtin_prefetch(position_at(records, triangle.third));
    }
    active.count = count;
}

/// Sets of a cluster's vertices: by kind those where its function is negative, then those that
/// surely face away.
constexpr unsigned kAwaySets = kMostKindsOfPass;
static_assert(kAwaySets + kMostKindsOfPass <= kSignSets, "a set of signs for each use");

/// Which signs a cluster has, of those that decide about its triangles.
struct ClusterSigns {
    VertexSigns vertices;
    bool mixed[kMostKindsOfPass] = {}, any_away[kMostKindsOfPass] = {};
    bool any_mixed = false;
};

/// Fills in the values of a kind, whose signs count for what is not surely away. `facing`: where
/// n·eye is negative.
template <class Kinds, class Kind>
static inline void find_signs(const ExtractionTask& task, const ClusterInSlot& place, unsigned kind,
                              bool test_facing, const BelowBound& facing, Batch& batch,
                              ClusterSigns& signs) {
    const unsigned groups = form_groups(place.cluster);
    BelowBound away, negative = facing;
    if constexpr (!Kind::kIsFacing) {
        const float least = task.kinds[Kinds::kFirst + kind].least_scaled_facing;
        if (test_facing)
            away = least == 0 ? facing : below(in_slot(batch.facing, place), groups, least);
        if (away.all) return;
        float* const values = in_slot(batch.values[kind], place);
        Kind::evaluate(task, place, values);
        negative = below(values, groups, 0);
    }
    if (!negative.any || negative.all) return;
    signs.mixed[kind] = signs.any_mixed = true;
    signs.vertices.set(kind, negative.bits);
    signs.any_away[kind] = away.any;
    if (away.any) signs.vertices.set(kAwaySets + kind, away.bits);
}

template <class Kinds>
static inline ClusterSigns find_all_signs(const ExtractionTask& task, const KeptCluster& kept,
                                          const ClusterInSlot& place, Batch& batch) {
    BelowBound facing;
    if (kept.test_facing) {
        const unsigned groups = form_groups(place.cluster);
        float* values = in_slot(batch.facing, place);
        evaluate_forms(reinterpret_cast<const FormGroup*>(place.memory), groups, task.eye, values);
        facing = below(values, groups, 0);
    }
    ClusterSigns signs;
    Kinds::for_each([&](auto kind, unsigned number) {
        if (kept.may_hold[number])
            find_signs<Kinds, decltype(kind)>(task, place, number, kept.test_facing, facing, batch,
                                              signs);
    });
    return signs;
}

/// Appends the triangles of a cluster in which a function changes its sign.
template <class Kinds>
static inline void find_mixed(const ExtractionTask& task, const ClusterInSlot& place,
                              const ClusterSigns& signs, Batch& batch) {
    const Cluster& cluster = place.cluster;
    const unsigned char* corners = place.memory + place.layout.corners;
    for (unsigned g = 0; g < mask_groups(cluster); ++g, corners += 3 * kMaskGroup) {
        const CornerLookup lookup[3] = {{corners, signs.vertices},
                                        {corners + kMaskGroup, signs.vertices},
                                        {corners + 2 * kMaskGroup, signs.vertices}};
        Kinds::for_each([&](auto kind, unsigned number) {
            if (!signs.mixed[number]) return;
            std::uint64_t unwanted =
                kind.unwanted(task.kinds[Kinds::kFirst + number].rules, cluster, g);
            if (signs.any_away[number]) {
                const unsigned away = kAwaySets + number;
                unwanted |= lookup[0](away) & lookup[1](away) & lookup[2](away);
            }
            const std::uint64_t n[3] = {lookup[0](number), lookup[1](number), lookup[2](number)};
            const std::uint64_t mixed = ((n[0] ^ n[1]) | (n[0] ^ n[2])) & ~unwanted;
            list_mixed(mixed, n, place, g * kMaskGroup, batch, batch.active[number]);
        });
    }
}

/// Fills in values and active triangles of a batch.
template <class Kinds>
static inline void find_active(const ClusterStore& store, const ExtractionTask& task,
                               const KeptCluster* kept, Batch& batch) {
    for (ActiveTriangles& active : batch.active)
        active.count = 0;
    for (unsigned slot = 0; slot < batch.count; ++slot) {
        const ClusterInSlot place = place_of(store, batch, slot);
        const ClusterSigns signs = find_all_signs<Kinds>(task, kept[slot], place, batch);
        if (signs.any_mixed) find_mixed<Kinds>(task, place, signs, batch);
    }
}

// ---- strips of the kinds that are found like that ----

template <class Kinds>
static void extract_strips(const ClusterStore& store, const ExtractionTask& task,
                           const KeptCluster* clusters, std::size_t count, SimdMemory& memory,
                           StripOutput* outputs) {
    Batch& batch = memory.batch;
    begin_batch<Kinds>(store, clusters, count, batch);
    find_active<Kinds>(store, task, clusters, batch);
    Kinds::for_each([&](auto kind, unsigned number) {
        append_strips<Kinds, decltype(kind)>(store, task, number, memory, outputs[number]);
    });
}

}  // namespace SIMD_SET

template <>
const RedrawLoops& functions_of<RedrawLoops, InstructionSet::SIMD_SET>() {
    using namespace SIMD_SET;
    static constexpr RedrawLoops functions = {
        {{cull<StandardKinds>, extract_strips<StandardKinds>},
         {cull<SuggestiveKinds>, extract_strips<SuggestiveKinds>},
         {cull<PhoticKinds>, extract_strips<PhoticKinds>},
         {cull<ApparentKinds>, extract_apparent_strips}}};
    return functions;
}

}  // namespace laplacian_lines
