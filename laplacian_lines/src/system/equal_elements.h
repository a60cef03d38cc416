// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "system/buckets.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// For each element the first equal one. Elements that equal nothing, not even themselves, need
/// hashes of their own: those of one hash are compared one by one.
template <class HashOf, class Equal>
std::vector<std::uint32_t> first_equals(std::size_t count, HashOf hash_of, Equal equal) {
    constexpr std::uint32_t kFree = 0xffffffffu;
    std::vector<std::uint32_t> first = large_array<std::uint32_t>(count);
    std::vector<std::uint32_t> hashes = large_array<std::uint32_t>(count);
    for_each_element(count,
                     [&](std::size_t i) { hashes[i] = std::uint32_t(hash_of(std::uint32_t(i))); });
    const std::size_t buckets = count / kBlockElements + 1;  // each with a table near at hand
    sort_in_buckets(count, buckets, [&](std::uint32_t i) {
        return std::size_t(std::uint64_t(hashes[i]) * buckets >> 32);
    }).for_each([&](std::size_t, const std::uint32_t* begin, const std::uint32_t* end) {
        std::size_t size = 2;
        while (size < 2 * std::size_t(end - begin))
            size *= 2;
        std::vector<std::uint32_t> slots(size, kFree);
        for (; begin != end; ++begin) {
            const std::uint32_t i = *begin;
            std::size_t slot = hashes[i] & (size - 1);
            while (slots[slot] != kFree &&
                   !(hashes[slots[slot]] == hashes[i] && equal(slots[slot], i)))
                slot = (slot + 1) & (size - 1);
            if (slots[slot] == kFree) slots[slot] = i;
            first[i] = slots[slot];
        }
    });
    return first;
}

/// Adds an integer to a hash, with constants of splitmix64. Every bit of the result depends on all
/// bits.
inline std::uint64_t mix_hash(std::uint64_t hash, std::uint64_t value) {
    std::uint64_t x = hash ^ value;
    x ^= x >> 31;
    x *= 0x9e3779b97f4a7c15;
    x ^= x >> 29;
    x *= 0xbf58476d1ce4e5b9;
    return x ^ x >> 32;
}

}  // namespace laplacian_lines
