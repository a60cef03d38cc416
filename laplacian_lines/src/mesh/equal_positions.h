// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstring>
#include <vector>

#include "system/equal_elements.h"

namespace laplacian_lines {

/// For each position the first one that equals it; those that are not finite equal only themselves.
inline std::vector<std::uint32_t> first_equal_positions(
    const std::vector<Eigen::Vector3d>& positions) {
    const auto hash_of = [&](std::uint32_t v) {
        if (!positions[v].allFinite()) return mix_hash(0, v);
        std::uint64_t hash = 0;
        for (double x : positions[v]) {
            x += 0.0;  // no −0
            std::uint64_t bits;
            std::memcpy(&bits, &x, sizeof bits);
            hash = mix_hash(hash, bits);
        }
        return hash;
    };
    return first_equals(positions.size(), hash_of, [&](std::uint32_t a, std::uint32_t b) {
        return positions[a] == positions[b];
    });
}

}  // namespace laplacian_lines
