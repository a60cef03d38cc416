// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// For each of `count` elements the first one that equals it. An element of a rare hash may equal
/// nothing, not even itself.
template <class HashOf, class Equal>
std::vector<std::uint32_t> first_equals(std::size_t count, HashOf hash_of, Equal equal) {
    constexpr std::uint32_t kFree = 0xffffffffu;
    std::size_t size = 2;
    while (size < 2 * count)
        size *= 2;
    std::vector<std::uint32_t> slots = large_array(size, kFree);
    std::vector<std::uint32_t> first = large_array<std::uint32_t>(count);
    std::vector<std::uint64_t> hashes = large_array<std::uint64_t>(count);
    for_each_element(count, [&](std::size_t i) { hashes[i] = hash_of(std::uint32_t(i)); });
    for (std::uint32_t i = 0; i < count; ++i) {
        std::size_t slot = hashes[i] & (size - 1);
        while (slots[slot] != kFree && !equal(slots[slot], i))
            slot = (slot + 1) & (size - 1);
        if (slots[slot] == kFree) slots[slot] = i;
        first[i] = slots[slot];
    }
    return first;
}

/// Of whole numbers, one after the other. Every bit of the result depends on all bits.
inline std::uint64_t mix_hash(std::uint64_t hash, std::uint64_t value) {
    std::uint64_t x = hash ^ value;
    x ^= x >> 31;
    x *= 0x9e3779b97f4a7c15;
    x ^= x >> 29;
    x *= 0xbf58476d1ce4e5b9;
    return x ^ x >> 32;
}

}  // namespace laplacian_lines
