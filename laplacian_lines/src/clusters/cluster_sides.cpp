// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/cluster_sides.h"

#include <algorithm>
#include <tuple>

#include "system/buckets.h"

namespace laplacian_lines {
namespace {

constexpr std::size_t kBuckets = 64;

/// A side of an edge that gets a number.
struct NumberedSide {
    std::uint32_t smaller, larger;  // vertices
    std::uint32_t place;            // 3 place + k

    bool operator<(const NumberedSide& other) const {
        return std::tie(smaller, larger, place) <
               std::tie(other.smaller, other.larger, other.place);
    }
};

}  // namespace

ClusterLinks link_clusters(const PreparedMesh& mesh, const CornerTable& sides,
                           const std::vector<std::uint8_t>& coarse, const Partition& partition) {
    ClusterLinks links;
    links.across = large_array(sides.side_count(), ClusterLinks::kNobody);
    std::vector<std::vector<NumberedSide>> found(partition.ranges.size());
    in_parallel(partition.ranges.size(), [&](std::size_t c) {
        const ClusterRange& range = partition.ranges[c];
        for (std::uint32_t place = range.begin; place < range.end; ++place)
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t side = 3 * partition.order[place] + k;
                if (!sides.has_neighbour(side)) continue;
                const std::uint32_t across = sides.across(side),
                                    other = partition.places[across / 3];
                if (other >= range.begin && other < range.end &&
                    goes_on_within(mesh, coarse, side, across)) {
                    links.across[3 * place + k] = other;
                } else {
                    const std::uint32_t from = begin_of(mesh.triangles, side),
                                        to = end_of(mesh.triangles, side);
                    found[c].push_back({std::min(from, to), std::max(from, to), 3 * place + k});
                }
            }
    });
    std::vector<NumberedSide> numbered;
    for (const auto& of_cluster : found)
        numbered.insert(numbered.end(), of_cluster.begin(), of_cluster.end());
    links.number_count = std::uint32_t(numbered.size() / 2);
    Buckets buckets = sort_in_buckets(numbered.size(), kBuckets, [&](std::uint32_t i) {
        return std::size_t(numbered[i].smaller) * kBuckets / mesh.size();
    });
    buckets.for_each([&](std::size_t bucket, std::uint32_t* begin, std::uint32_t* end) {
        std::sort(begin, end,
                  [&](std::uint32_t a, std::uint32_t b) { return numbered[a] < numbered[b]; });
        std::uint32_t number = buckets.begins[bucket];
        for (const std::uint32_t* i = begin; i != end; ++i)  // two of each edge
            links.across[numbered[*i].place] = ClusterLinks::kNumber + number++ / 2;
    });
    return links;
}

}  // namespace laplacian_lines
