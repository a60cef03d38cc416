// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/coarse_horizon.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "clusters/linear_forms.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kNoPlace = 0xffffffffu;

std::size_t bytes(const Planes& planes) {
    return 4 * sizeof(float) * planes.x.capacity();
}

class HorizonBuilder {
public:
    HorizonBuilder(const PreparedMesh& mesh, const Field& field)
        : mesh_(mesh), field_(field), place_of_vertex_(mesh.size(), kNoPlace) {}

    void add_triangle(const Triangle& t) {
        const auto corner = [&](unsigned k) { return mesh_.positions[t[k]]; };
        horizon_.planes.add(area_vector(mesh_, t).stableNormalized(), corner(0));
        centres_.push_back((corner(0) + corner(1) + corner(2)) / 3);
    }

    void add_edge(std::uint32_t from, std::uint32_t to, std::uint32_t a, std::uint32_t b,
                  bool is_reversed, bool is_body) {
        const bool hollow = is_body && !is_reversed && is_hollow(a, b);
        horizon_.edges.push_back({{vertex(from), vertex(to)}, {a, b}, is_reversed, hollow});
    }

    void add_outer_edge(std::uint32_t number, std::uint32_t from, std::uint32_t to,
                        std::uint32_t triangle) {
        horizon_.outer_edges.push_back({number, {vertex(from), vertex(to)}, triangle});
    }

    CoarseHorizon take() {
        std::sort(horizon_.outer_edges.begin(), horizon_.outer_edges.end(),
                  [](const auto& a, const auto& b) { return a.number < b.number; });
        return std::move(horizon_);
    }

private:
    bool is_hollow(std::uint32_t a, std::uint32_t b) const {
        constexpr double least = 0.02;  // sine
        const Planes& planes = horizon_.planes;
        const Eigen::Vector3d normal(planes.x[a], planes.y[a], planes.z[a]);
        const Eigen::Vector3d between = centres_[b] - centres_[a];
        return normal.dot(between) > least * between.norm();
    }

    std::uint32_t vertex(std::uint32_t v) {
        std::uint32_t& place = place_of_vertex_[v];
        if (place == kNoPlace) {
            place = std::uint32_t(horizon_.positions.size());
            horizon_.positions.push_back(mesh_.positions[v].cast<float>());
            horizon_.facing.add(bounded(field_.normals[mesh_.original_vertex[v]], 1, 2),
                                mesh_.positions[v]);
        }
        return place;
    }

    const PreparedMesh& mesh_;
    const Field& field_;
    CoarseHorizon horizon_;
    std::vector<Eigen::Vector3d> centres_;  // of the triangles
    std::vector<std::uint32_t> place_of_vertex_;
};

}  // namespace

std::size_t CoarseHorizon::memory() const {
    return edges.capacity() * sizeof(Edge) + outer_edges.capacity() * sizeof(OuterEdge) +
           positions.capacity() * sizeof(Eigen::Vector3f) + bytes(facing) + bytes(planes);
}

CoarseHorizon find_coarse_horizon(const PreparedMesh& mesh, const Field& field,
                                  const CornerTable& sides, const std::vector<std::uint8_t>& coarse,
                                  const Partition& partition, const ClusterLinks& links,
                                  bool is_body) {
    if (std::find(coarse.begin(), coarse.end(), 1) == coarse.end()) return {};
    HorizonBuilder builder(mesh, field);
    std::vector<std::uint32_t> places(coarse.size(), kNoPlace);  // of coarse triangles
    std::uint32_t count = 0;
    for (std::size_t t = 0; t < coarse.size(); ++t)
        if (coarse[t]) {
            places[t] = count++;
            builder.add_triangle(mesh.triangles[t]);
        }
    for (std::uint32_t side = 0; side < sides.side_count(); ++side) {
        const std::uint32_t t = side / 3;
        if (!coarse[t] || !sides.has_neighbour(side)) continue;
        const std::uint32_t across = sides.across(side), from = begin_of(mesh.triangles, side),
                            to = end_of(mesh.triangles, side);
        if (!coarse[across / 3])
            builder.add_outer_edge(
                links.across[3 * partition.places[t] + side % 3] - ClusterLinks::kNumber, from, to,
                places[t]);
        else if (side < across)
            builder.add_edge(from, to, places[t], places[across / 3],
                             from == begin_of(mesh.triangles, across), is_body);
    }
    return builder.take();
}

}  // namespace laplacian_lines
