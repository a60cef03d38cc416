// SPDX-License-Identifier: GPL-3.0-or-later
#include "midpoint_subdivision.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace test_meshes {

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

/// Midpoints by the edges' ends, with space known beforehand: several times as fast as a hash map.
class Middles {
public:
    explicit Middles(const TriangleMesh& mesh)
        : first_(mesh.positions.size() + 1, 0), used_(mesh.positions.size(), 0) {
        for (const Triangle& t : mesh.triangles)
            for (int k = 0; k < 3; ++k)
                ++first_[std::min(t[k], t[(k + 1) % 3]) + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        middles_.resize(first_.back());
    }

    /// Of the edge a, b; `make` creates a missing one.
    template <class Make>
    std::uint32_t find(std::uint32_t a, std::uint32_t b, Make make) {
        const auto [low, high] = std::minmax(a, b);
        Middle* const begin = middles_.data() + first_[low];
        Middle* const end = begin + used_[low];
        for (Middle* m = begin; m != end; ++m)
            if (m->high == high) return m->vertex;
        ++used_[low];
        *end = {high, make(low, high)};
        return end->vertex;
    }

private:
    struct Middle {
        std::uint32_t high, vertex;
    };
    std::vector<std::uint32_t> first_, used_;  ///< by the lower end
    std::vector<Middle> middles_;
};

/// Calls add_vertex(a, b) for each edge once, which appends a vertex.
template <class AddVertex>
void cut_in_four(TriangleMesh& mesh, AddVertex add_vertex) {
    Middles middles(mesh);
    const auto make = [&](std::uint32_t a, std::uint32_t b) {
        add_vertex(a, b);
        return std::uint32_t(mesh.positions.size() - 1);
    };
    std::vector<Triangle> triangles;
    triangles.reserve(4 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middles.find(a, b, make), bc = middles.find(b, c, make),
                            ca = middles.find(c, a, make);
        for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
            triangles.push_back(t);
    }
    mesh.triangles.swap(triangles);
}

std::vector<Eigen::Vector3d> vertex_normals(const TriangleMesh& mesh) {
    std::vector<Eigen::Vector3d> normals(mesh.positions.size(), Eigen::Vector3d::Zero());
    for (const auto& [a, b, c] : mesh.triangles) {
        const Eigen::Vector3d area = (mesh.positions[b] - mesh.positions[a])
                                         .cross(mesh.positions[c] - mesh.positions[a]);
        for (const std::uint32_t v : {a, b, c})
            normals[v] += area;
    }
    for (Eigen::Vector3d& n : normals)
        n.normalize();
    return normals;
}

}  // namespace

void subdivide(TriangleMesh& mesh, Field& field) {
    cut_in_four(mesh, [&](std::uint32_t a, std::uint32_t b) { add_vertex(mesh, field, a, b); });
    field.scale.mean_edge /= 2;
}

void subdivide(laplacian_lines::TriangleMesh& mesh, int times) {
    for (int i = 0; i < times; ++i)
        cut_in_four(mesh, [&](std::uint32_t a, std::uint32_t b) {
            mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]) / 2);
        });
}

void refine(laplacian_lines::TriangleMesh& mesh, int times) {
    for (int i = 0; i < times; ++i) {
        const std::vector<Eigen::Vector3d> normals = vertex_normals(mesh);
        cut_in_four(mesh, [&](std::uint32_t a, std::uint32_t b) {
            const Eigen::Vector3d p = mesh.positions[a], q = mesh.positions[b];
            const Eigen::Vector3d bend =
                normals[a] * normals[a].dot(q - p) + normals[b] * normals[b].dot(p - q);
            mesh.positions.push_back((p + q) / 2 - bend / 8);
        });
    }
}

}  // namespace test_meshes
