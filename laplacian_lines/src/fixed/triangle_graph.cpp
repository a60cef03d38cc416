// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/triangle_graph.h"

#include <Eigen/Geometry>
#include <atomic>

#include "system/large_array.h"
#include "system/parallel.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

/// Notes of both sides of an edge between clusters: each finds the other's by the carry-less sum,
/// whichever came first.
struct EdgeNotes {
    std::atomic<std::uint32_t> triangles{0}, vertices{0};

    void note(std::uint32_t triangle, std::uint32_t vertex) {
        triangles.fetch_xor(triangle, std::memory_order_relaxed);
        vertices.fetch_xor(vertex, std::memory_order_relaxed);
    }
};

class GraphBuilder {
    using Node = TriangleGraph::Node;

public:
    GraphBuilder(const ExtractorData& data, TriangleGraph& graph)
        : data_(data),
          graph_(graph),
          placed_(place_clusters(data)),
          notes_(data.border_edge_count) {
        graph.records = records_of(data.store());
        for (const Cluster& cluster : data.clusters)
            graph.count += cluster.triangle_count;
        graph.triangles.reset(new Node[graph.count]);  // written by all threads
        advise_huge_pages(graph.triangles.get(), graph.count * sizeof(Node));
    }

    void run() {
        in_parallel(placed_.size(), [&](std::size_t c) { write(c); });
        in_parallel(placed_.size(), [&](std::size_t c) { link(c); });
    }

private:
    void write(std::size_t c) {
        const PlacedCluster& placed = placed_[c];
        const auto first_record = std::uint32_t(placed.records - graph_.records);
        for (unsigned t = 0; t < placed.cluster->triangle_count; ++t) {
            Node& node = graph_.triangles[placed_[c].first_triangle + t];
            for (unsigned k = 0; k < 3; ++k)
                node.corners[k] = first_record + placed.triangle(t).corners[k];
            set_plane(node);
            node.reversed = 0;
            for_each_side(c, t, [&](unsigned k, std::uint8_t neighbour, std::uint32_t vertex) {
                if (neighbour == kNoNeighbour)
                    node.neighbours[k] = TriangleGraph::kNone;
                else if (neighbour < placed.cluster->triangle_count)
                    node.neighbours[k] = placed_[c].first_triangle + neighbour;
                else
                    notes_[edge_of(c, neighbour)].note(placed_[c].first_triangle + t, vertex);
            });
        }
    }

    /// Across the edges between clusters.
    void link(std::size_t c) {
        const unsigned count = placed_[c].cluster->triangle_count;
        for (unsigned t = 0; t < count; ++t) {
            const std::uint32_t triangle = placed_[c].first_triangle + t;
            Node& node = graph_.triangles[triangle];
            for_each_side(c, t, [&](unsigned k, std::uint8_t neighbour, std::uint32_t) {
                if (neighbour == kNoNeighbour || neighbour < count) return;
                const EdgeNotes& notes = notes_[edge_of(c, neighbour)];
                node.neighbours[k] = notes.triangles.load(std::memory_order_relaxed) ^ triangle;
                const bool begin_alike = notes.vertices.load(std::memory_order_relaxed) == 0;
                node.reversed |= std::uint32_t(begin_alike) << k;
            });
        }
    }

    template <class Visit>
    void for_each_side(std::size_t c, unsigned t, const Visit& visit) const {
        const ClusterTriangle& triangle = placed_[c].triangle(t);
        for (unsigned k = 0; k < 3; ++k)
            visit(k, triangle.neighbours[k], placed_[c].vertices[triangle.corners[k]]);
    }

    std::uint32_t edge_of(std::size_t c, std::uint8_t neighbour) const {
        const Cluster& cluster = *placed_[c].cluster;
        return data_.border_edges[cluster.first_border_edge + neighbour - cluster.triangle_count];
    }

    void set_plane(Node& node) const {
        const auto corner = [&](unsigned k) {
            return Eigen::Map<const Eigen::Vector3f>(graph_.records[node.corners[k]].position);
        };
        const Eigen::Vector3f a = corner(0), b = corner(1), c = corner(2);
        const Eigen::Vector3f product = (b - a).cross(c - a);
        const float length = length_of(product);
        node.area = length / 2;
        node.normal = length > 0 ? Eigen::Vector3f(product / length) : Eigen::Vector3f::Zero();
        node.centre = (a + b + c) / 3;
    }

    const ExtractorData& data_;
    TriangleGraph& graph_;
    const std::vector<PlacedCluster> placed_;
    std::vector<EdgeNotes> notes_;  // by number of the edge
};

}  // namespace

TriangleGraph build_triangle_graph(const ExtractorData& data) {
    TriangleGraph graph;
    GraphBuilder(data, graph).run();
    return graph;
}

}  // namespace laplacian_lines
