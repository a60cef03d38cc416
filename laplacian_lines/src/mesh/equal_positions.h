// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "mesh/bounding_box.h"
#include "system/equal_elements.h"

namespace laplacian_lines {

/// Share of the largest coordinate below which a number is a rounded 0: 128 roundings of doubles.
/// CAD programs leave 1e-15 where faces meet.
constexpr double kZeroShare = 0x1p-46;

/// For each position the first equal one; non-finite ones equal only themselves. What counts as
/// zero is told by the vertices that the triangles use: others may be anywhere.
inline std::vector<std::uint32_t> first_equal_positions(
    const std::vector<Eigen::Vector3d>& positions, const std::vector<Triangle>& triangles) {
    const double least =
        kZeroShare * largest_coordinates(bounding_box(positions, triangles)).maxCoeff();
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
               rounded(p.z()) == rounded(q.z()) && p.allFinite();
    });
}

/// For each triangle the first one with the same corners; normal_form(triangle) is the same for
/// equal ones: their corners sorted, or turned to begin with the smallest, which tells triangles
/// that face opposite ways apart.
template <class NormalForm>
std::vector<std::uint32_t> first_equal_triangles(const std::vector<Triangle>& triangles,
                                                 NormalForm normal_form) {
    const auto hash_of = [&](std::uint32_t i) {
        const auto [a, b, c] = normal_form(triangles[i]);
        return mix_hash(mix_hash(mix_hash(0, a), b), c);
    };
    return first_equals(triangles.size(), hash_of, [&](std::uint32_t a, std::uint32_t b) {
        return normal_form(triangles[a]) == normal_form(triangles[b]);
    });
}

}  // namespace laplacian_lines
