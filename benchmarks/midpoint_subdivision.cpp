// SPDX-License-Identifier: GPL-3.0-or-later
#include "midpoint_subdivision.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace benchmarks {

using namespace laplacian_lines;

namespace {

ShapeOperator middle(const ShapeOperator& a, const ShapeOperator& b) {
    return {(a.xx + b.xx) / 2, (a.yy + b.yy) / 2, (a.zz + b.zz) / 2,
            (a.yz + b.yz) / 2, (a.xz + b.xz) / 2, (a.xy + b.xy) / 2};
}

void add_vertex(TriangleMesh& mesh, Field& field, std::uint32_t a, std::uint32_t b) {
    mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]) / 2);
    field.normals.push_back((field.normals[a] + field.normals[b]).normalized());
    field.laplacian_normals.push_back((field.laplacian_normals[a] + field.laplacian_normals[b]) /
                                      2);
    field.shape_operators.push_back(middle(field.shape_operators[a], field.shape_operators[b]));
    field.kernel_sizes.push_back((field.kernel_sizes[a] + field.kernel_sizes[b]) / 2);
}

}  // namespace

void subdivide(TriangleMesh& mesh, Field& field) {
    std::unordered_map<std::uint64_t, std::uint32_t> middles;
    middles.reserve(3 * mesh.triangles.size() / 2);
    const auto middle_of = [&](std::uint32_t a, std::uint32_t b) {
        const auto [low, high] = std::minmax(a, b);
        const auto [found, is_new] = middles.try_emplace(std::uint64_t(low) << 32 | high,
                                                         std::uint32_t(mesh.positions.size()));
        if (is_new) add_vertex(mesh, field, low, high);
        return found->second;
    };
    std::vector<Triangle> triangles;
    triangles.reserve(4 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
        for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
            triangles.push_back(t);
    }
    mesh.triangles.swap(triangles);
    field.scale.mean_edge /= 2;
}

}  // namespace benchmarks
