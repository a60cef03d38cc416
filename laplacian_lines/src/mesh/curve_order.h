// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "system/buckets.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// By number of seven bits: its bits, with room between them for those of the other axes.
template <int Dim>
std::array<std::uint64_t, 128> spread_numbers() {
    std::array<std::uint64_t, 128> table{};
    for (std::uint64_t x = 0; x < 128; ++x)
        for (int bit = 0; bit < 7; ++bit)
            table[x] |= (x >> bit & 1) << (bit * Dim);
    return table;
}

/// Indices along a space-filling curve (G. Morton, 1966), so that neighbours in the order are
/// mostly neighbours in space. Points outside the box count as on its border.
template <int Dim, class PointOf>
std::vector<std::uint32_t> order_along_curve(std::size_t count,
                                             const Eigen::AlignedBox<float, Dim>& box,
                                             PointOf point_of) {
    constexpr int kBits = 21;  // of each axis: three are 63
    // Many are sorted by their first bits, then each bucket on its own, several at once.
    const int bucket_bits = count > kBlockElements ? 12 : 0;
    const auto table = spread_numbers<Dim>();
    const auto spread = [&](std::uint64_t x) {
        std::uint64_t result = 0;
        for (int bit = 0; bit < kBits; bit += 7)  // seven bits at a time
            result |= table[x >> bit & 127] << (bit * Dim);
        return result;
    };
    auto places = large_array<std::uint64_t>(count);
    for_each_element(count, [&](std::size_t i) {
        const Eigen::Matrix<float, Dim, 1> point = point_of(std::uint32_t(i));
        for (int axis = 0; axis < Dim; ++axis) {
            const float share = (point[axis] - box.min()[axis]) / box.sizes()[axis];
            const float at = share > 0 ? std::min(share, 1.f) : 0;  // 0 for NaN
            places[i] |= spread(std::uint64_t(at * float((1 << kBits) - 1))) << axis;
        }
    });
    Buckets buckets = sort_in_buckets(count, std::size_t(1) << bucket_bits, [&](std::uint32_t i) {
        return places[i] >> (Dim * kBits - bucket_bits);
    });
    buckets.for_each([&](std::size_t, std::uint32_t* begin, std::uint32_t* end) {
        std::sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
            return places[a] != places[b] ? places[a] < places[b] : a < b;
        });
    });
    return std::move(buckets.numbers);
}

}  // namespace laplacian_lines
