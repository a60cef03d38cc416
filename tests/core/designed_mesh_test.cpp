// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of CAD programs: vertices are where the form needs them, triangles however they came.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generators.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;

/// A cylinder with a fillet at its upper lid. Each lid is a fan from one of its vertices.
TriangleMesh knob(std::uint32_t fan) {
    constexpr std::uint32_t kSides = 60;
    std::vector<test_meshes::Ring> rings = {test_meshes::circle(kSides, 1, -0.5)};
    for (int i = 0; i <= 6; ++i)
        rings.push_back(test_meshes::circle(kSides, 0.9 + 0.1 * std::cos(M_PI / 12 * i),
                                            0.4 + 0.1 * std::sin(M_PI / 12 * i)));
    TriangleMesh mesh = test_meshes::walls(rings);
    const auto last = std::uint32_t(mesh.positions.size()) - kSides;
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const std::uint32_t next = (i + 1) % kSides;
        if (i == fan || next == fan) continue;
        mesh.triangles.push_back({fan, next, i});
        mesh.triangles.push_back({last + fan, last + i, last + next});
    }
    return mesh;
}

TEST(DesignedMesh, HasTheSameFieldHoweverItsFacesAreCut) {
    const Field one = precompute(knob(0)), other = precompute(knob(23));
    float largest = 0;
    for (const Eigen::Vector3f& laplacian : one.laplacian_normals)
        largest = std::max(largest, laplacian.norm());
    ASSERT_GT(largest, 0);
    for (std::size_t v = 0; v < one.laplacian_normals.size(); ++v)
        EXPECT_LT((one.laplacian_normals[v] - other.laplacian_normals[v]).norm(), 0.1f * largest)
            << v;
}

}  // namespace
