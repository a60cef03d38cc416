// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/coarse_horizon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

#include "clusters/insides.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kNoPlace = 0xffffffffu;

class HorizonBuilder {
public:
    HorizonBuilder(const ExtractorData& data, CoarseHorizon& horizon)
        : data_(data), horizon_(horizon) {}

    void build() {
        const std::vector<PlacedCluster> clusters = place_clusters(data_);
        is_body_ = is_body(clusters);
        for (const PlacedCluster& placed : clusters)
            if (has_coarse(*placed.cluster)) add_cluster(placed);
        std::sort(numbered_.begin(), numbered_.end(),
                  [](const auto& a, const auto& b) { return a.number < b.number; });
        for (std::size_t i = 0; i < numbered_.size(); ++i) {
            const CoarseHorizon::OuterEdge& side = numbered_[i];
            if (i + 1 == numbered_.size() || numbered_[i + 1].number != side.number) {
                horizon_.outer_edges.push_back(side);
                continue;
            }
            const CoarseHorizon::OuterEdge& other = numbered_[++i];
            add_edge(side.vertices, side.triangle, other.triangle,
                     side.vertices[0] == other.vertices[0]);
        }
        for (std::size_t v = 0; v < records_.size(); ++v)
            add_vertex(*records_[v]);
    }

private:
    static bool has_coarse(const Cluster& cluster) {
        return std::any_of(std::begin(cluster.coarse), std::end(cluster.coarse),
                           [](std::uint64_t bits) { return bits != 0; });
    }
    static bool is_coarse(const Cluster& cluster, unsigned triangle) {
        return cluster.coarse[triangle / kMaskGroup] >> triangle % kMaskGroup & 1;
    }

    void add_cluster(const PlacedCluster& placed) {
        const Cluster& cluster = *placed.cluster;
        std::vector<std::uint32_t> places(cluster.triangle_count, kNoPlace);
        for (unsigned t = 0; t < cluster.triangle_count; ++t)
            if (is_coarse(cluster, t)) places[t] = add_triangle(placed, placed.triangle(t));
        for (unsigned t = 0; t < cluster.triangle_count; ++t) {
            if (places[t] == kNoPlace) continue;
            for (unsigned k = 0; k < 3; ++k)
                add_side(placed, t, k, places);
        }
    }

    std::uint32_t add_triangle(const PlacedCluster& placed, const ClusterTriangle& triangle) {
        const auto corner = [&](unsigned k) {
            return position_of(placed.records[triangle.corners[k]]).cast<double>().eval();
        };
        const Eigen::Vector3d area = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        const std::size_t place = horizon_.planes.size();
        horizon_.planes.resize(place + 1);
        horizon_.planes.set(place, area.stableNormalized(), corner(0));
        centres_.push_back((corner(0) + corner(1) + corner(2)) / 3);
        return std::uint32_t(place);
    }

    /// The side from corner k on.
    void add_side(const PlacedCluster& placed, unsigned t, unsigned k,
                  const std::vector<std::uint32_t>& places) {
        const ClusterTriangle& triangle = placed.triangle(t);
        const Cluster& cluster = *placed.cluster;
        const unsigned neighbour = triangle.neighbours[k];
        const bool is_inside = neighbour < cluster.triangle_count;
        if (neighbour == kNoNeighbour || (is_inside && neighbour < t)) return;
        const std::uint32_t vertices[2] = {vertex(placed, triangle.corners[k]),
                                           vertex(placed, triangle.corners[(k + 1) % 3])};
        if (is_inside) {
            add_edge(vertices, places[t], places[neighbour], false);
        } else {
            const std::uint32_t place =
                cluster.first_border_edge + neighbour - cluster.triangle_count;
            numbered_.push_back({data_.border_edges[place], {vertices[0], vertices[1]}, places[t]});
        }
    }

    bool is_hollow(std::uint32_t a, std::uint32_t b) const {
        constexpr double least = 0.02;  // sine
        const Eigen::Vector3d normal(horizon_.planes.x[a], horizon_.planes.y[a],
                                     horizon_.planes.z[a]);
        const Eigen::Vector3d between = centres_[b] - centres_[a];
        return normal.dot(between) > least * between.norm();
    }

    void add_edge(const std::uint32_t vertices[2], std::uint32_t a, std::uint32_t b,
                  bool is_reversed) {
        const bool hollow = is_body_ && !is_reversed && is_hollow(a, b);
        horizon_.edges.push_back({{vertices[0], vertices[1]}, {a, b}, is_reversed, hollow});
    }

    std::uint32_t vertex(const PlacedCluster& placed, unsigned corner) {
        if (place_of_vertex_.empty()) place_of_vertex_.resize(data_.vertex_count, kNoPlace);
        std::uint32_t& place = place_of_vertex_[placed.vertices[corner]];
        if (place == kNoPlace) {
            place = std::uint32_t(records_.size());
            records_.push_back(&placed.records[corner]);
        }
        return place;
    }

    void add_vertex(const VertexRecord& record) {
        const std::size_t place = horizon_.positions.size();
        horizon_.positions.push_back(position_of(record));
        horizon_.facing.resize(place + 1);
        horizon_.facing.set(place, normal_of(record).cast<double>(),
                            position_of(record).cast<double>());
    }

    const ExtractorData& data_;
    CoarseHorizon& horizon_;
    bool is_body_ = false;
    std::vector<Eigen::Vector3d> centres_;  // of the triangles
    std::vector<std::uint32_t> place_of_vertex_;
    std::vector<const VertexRecord*> records_;        // by place
    std::vector<CoarseHorizon::OuterEdge> numbered_;  // sides
};

std::size_t bytes(const Planes& planes) {
    return 4 * sizeof(float) * planes.x.capacity();
}

}  // namespace

std::size_t CoarseHorizon::memory() const {
    return edges.capacity() * sizeof(Edge) + outer_edges.capacity() * sizeof(OuterEdge) +
           positions.capacity() * sizeof(Eigen::Vector3f) + bytes(facing) + bytes(planes);
}

CoarseHorizon find_coarse_horizon(const ExtractorData& data) {
    CoarseHorizon horizon;
    HorizonBuilder(data, horizon).build();
    return horizon;
}

}  // namespace laplacian_lines
