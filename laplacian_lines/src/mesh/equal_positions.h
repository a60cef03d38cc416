// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "system/equal_elements.h"

namespace laplacian_lines {

/// Share of the largest coordinate below which a number is a rounded 0, as CAD programs leave them
/// where faces meet.
constexpr double kZeroShare = 0x1p-46;

/// For each position the first equal one; non-finite ones equal only themselves.
inline std::vector<std::uint32_t> first_equal_positions(
    const std::vector<Eigen::Vector3d>& positions) {
    const auto largest_of = [&](std::size_t begin, std::size_t end) {
        double largest = 0;
        for (std::size_t v = begin; v < end; ++v)
            if (positions[v].allFinite())
                largest = std::max(largest, positions[v].cwiseAbs().maxCoeff());
        return largest;
    };
    const double largest = join_blocks(positions.size(), 0., largest_of,
                                       [](double a, double b) { return std::max(a, b); });
    const double least = kZeroShare * largest;
    const auto rounded = [=](double x) { return std::abs(x) <= least ? 0.0 : x; };
    const auto hash_of = [&](std::uint32_t v) {
        if (!positions[v].allFinite()) return mix_hash(0, v);
        std::uint64_t hash = 0;
        for (double x : positions[v]) {
            x = rounded(x);
            std::uint64_t bits;
            std::memcpy(&bits, &x, sizeof bits);
            hash = mix_hash(hash, bits);
        }
        return hash;
    };
    return first_equals(positions.size(), hash_of, [&](std::uint32_t a, std::uint32_t b) {
        const Eigen::Vector3d &p = positions[a], &q = positions[b];
        return rounded(p.x()) == rounded(q.x()) && rounded(p.y()) == rounded(q.y()) &&
               rounded(p.z()) == rounded(q.z());
    });
}

}  // namespace laplacian_lines
