// SPDX-License-Identifier: GPL-3.0-or-later
#include "cluster_partition.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "cluster_data.h"
#include "edge_topology.h"

namespace laplacian_lines {

std::vector<TriangleSides> find_sides(const PreparedMesh& mesh, std::size_t& edge_count) {
    const EdgeTopology topology = build_edge_topology(mesh.size(), mesh.triangles);
    edge_count = topology.edge_count;
    struct Users {
        std::uint32_t count = 0, sides[2] = {0, 0};  // 3·triangle + side
    };
    std::vector<Users> users(edge_count);
    std::vector<TriangleSides> sides(mesh.triangles.size());
    for (std::uint32_t t = 0; t < sides.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t edge = topology.edges_of_triangle[t][(k + 2) % 3];
            sides[t].edges[k] = edge;
            sides[t].neighbours[k] = TriangleSides::kNone;
            sides[t].reversed[k] = false;
            Users& u = users[edge];
            if (u.count < 2) u.sides[u.count] = 3 * t + k;
            ++u.count;
        }
    for (const Users& u : users) {
        if (u.count != 2) continue;
        const std::uint32_t t0 = u.sides[0] / 3, k0 = u.sides[0] % 3;
        const std::uint32_t t1 = u.sides[1] / 3, k1 = u.sides[1] % 3;
        sides[t0].neighbours[k0] = t1;
        sides[t1].neighbours[k1] = t0;
        const bool reversed = mesh.triangles[t0][k0] == mesh.triangles[t1][k1];
        sides[t0].reversed[k0] = sides[t1].reversed[k1] = reversed;
    }
    return sides;
}

namespace {

class Partition {
public:
    Partition(const PreparedMesh& mesh, const std::vector<TriangleSides>& sides,
              std::vector<std::uint32_t>& order)
        : mesh_(mesh),
          sides_(sides),
          order_(order),
          mark_of_vertex_(mesh.size(), 0),
          mark_of_triangle_(mesh.triangles.size(), 0) {
        order.resize(mesh.triangles.size());
        std::iota(order.begin(), order.end(), 0u);
        for (const Triangle& t : mesh.triangles)
            centres_.push_back(
                (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]).cast<float>());
    }

    void split(std::uint32_t begin, std::uint32_t end) {
        const std::uint32_t size = end - begin;
        if (size <= kClusterTriangles && fits(begin, end)) {
            ranges_.push_back({begin, end});
            return;
        }
        // Full clusters on the left keep all but the last ones full.
        const std::uint32_t full = size / 2 / kClusterTriangles * kClusterTriangles;
        const std::uint32_t middle = begin + (full > 0 ? full : size / 2);
        order_by_longest_axis(begin, middle, end);
        split(begin, middle);
        split(middle, end);
    }

    std::vector<ClusterRange> ranges_;

private:
    void order_by_longest_axis(std::uint32_t begin, std::uint32_t middle, std::uint32_t end) {
        Eigen::AlignedBox3f box;
        for (std::uint32_t i = begin; i < end; ++i)
            box.extend(centres_[order_[i]]);
        int axis;
        box.sizes().maxCoeff(&axis);
        std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                         [&](std::uint32_t i, std::uint32_t j) {
                             const float a = centres_[i][axis], b = centres_[j][axis];
                             return a != b ? a < b : i < j;
                         });
    }

    /// Whether these triangles keep within a cluster's numbers of vertices and of numbers.
    bool fits(std::uint32_t begin, std::uint32_t end) {
        ++mark_;
        unsigned vertices = 0, numbers = end - begin;
        for (std::uint32_t i = begin; i < end; ++i) {
            mark_of_triangle_[order_[i]] = mark_;
            for (std::uint32_t v : mesh_.triangles[order_[i]]) {
                vertices += mark_of_vertex_[v] != mark_;
                mark_of_vertex_[v] = mark_;
            }
        }
        for (std::uint32_t i = begin; i < end; ++i) {
            const TriangleSides& s = sides_[order_[i]];
            for (int k = 0; k < 3; ++k)
                numbers += s.neighbours[k] != TriangleSides::kNone &&
                           (s.reversed[k] || mark_of_triangle_[s.neighbours[k]] != mark_);
        }
        return vertices <= kClusterVertices && numbers <= kClusterNumbers;
    }

    const PreparedMesh& mesh_;
    const std::vector<TriangleSides>& sides_;
    std::vector<std::uint32_t>& order_;
    std::vector<Eigen::Vector3f> centres_;  // times 3
    std::vector<std::uint32_t> mark_of_vertex_, mark_of_triangle_;
    std::uint32_t mark_ = 0;
};

}  // namespace

std::vector<ClusterRange> partition(const PreparedMesh& mesh,
                                    const std::vector<TriangleSides>& sides,
                                    std::vector<std::uint32_t>& order) {
    Partition partition(mesh, sides, order);
    if (!mesh.triangles.empty()) partition.split(0, std::uint32_t(mesh.triangles.size()));
    return std::move(partition.ranges_);
}

}  // namespace laplacian_lines
