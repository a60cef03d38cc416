// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Numbers sorted into buckets, ascending in each.
struct Buckets {
    std::vector<std::uint32_t> numbers;
    std::vector<std::uint32_t> begins;  ///< of buckets in `numbers`, and an end

    /// Calls body(bucket, begin, end) with the numbers of each bucket, on several threads.
    template <class Body>
    void for_each(Body body) {
        in_parallel(begins.size() - 1, [&](std::size_t bucket) {
            body(bucket, numbers.data() + begins[bucket], numbers.data() + begins[bucket + 1]);
        });
    }
};

/// Sorts the numbers i below `count` by bucket_of(i) < `buckets`, which is called twice.
template <class BucketOf>
Buckets sort_in_buckets(std::size_t count, std::size_t buckets, BucketOf bucket_of) {
    constexpr std::size_t kMostParts = 64;
    const std::size_t size = std::max(kBlockElements, count / kMostParts + 1),
                      parts = (count + size - 1) / size;
    std::vector<std::uint32_t> places(buckets * parts + 1);  // by bucket, then by part
    const auto in_parts = [&](auto body) {
        in_parallel(parts, [&](std::size_t part) {
            for (std::size_t i = part * size; i < std::min(count, (part + 1) * size); ++i)
                body(std::uint32_t(i), places[bucket_of(std::uint32_t(i)) * parts + part]);
        });
    };
    in_parts([](std::uint32_t, std::uint32_t& place) { ++place; });
    std::exclusive_scan(places.begin(), places.end(), places.begin(), 0u);
    Buckets result{large_array<std::uint32_t>(count), std::vector<std::uint32_t>(buckets + 1)};
    for (std::size_t bucket = 0; bucket <= buckets; ++bucket)
        result.begins[bucket] = places[bucket * parts];
    in_parts([&](std::uint32_t i, std::uint32_t& place) { result.numbers[place++] = i; });
    return result;
}

}  // namespace laplacian_lines
