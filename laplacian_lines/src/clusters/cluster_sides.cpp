// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/cluster_sides.h"

#include <algorithm>
#include <atomic>
#include <tuple>

#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr std::size_t kBuckets = 64;
constexpr std::size_t kClustersOfPart = 64;  // for a thread at a time
constexpr std::size_t kSidesOfCluster = 80;  // open ones to reserve memory for

/// A side of an edge that may have more of them in other clusters.
struct OpenSide {
    std::uint32_t smaller, larger;  // vertices
    std::uint32_t side;

    bool operator<(const OpenSide& other) const {
        return std::tie(smaller, larger, side) < std::tie(other.smaller, other.larger, other.side);
    }
    bool same_edge(const OpenSide& other) const {
        return smaller == other.smaller && larger == other.larger;
    }
};

/// Which vertices belong to several clusters.
class VertexOwners {
public:
    VertexOwners(const PreparedMesh& mesh, const Partition& partition) : owner_(mesh.size()) {
        in_parallel(partition.ranges.size(), [&](std::size_t c) {
            const ClusterRange& range = partition.ranges[c];
            unsigned known = 0;  // vertices have numbers in this order
            for (std::uint32_t p = range.begin; p < range.end; ++p)
                for (std::size_t k = 0; k < 3; ++k) {
                    if (partition.corners[3 * std::size_t(p) + k] < known) continue;
                    note(mesh.triangles[partition.order[p]][k], std::uint32_t(c));
                    ++known;
                }
        });
    }
    bool is_shared(std::uint32_t vertex) const {
        return owner_[vertex].load(std::memory_order_relaxed) == kSeveral;
    }

private:
    static constexpr std::uint32_t kSeveral = 0xffffffffu;

    /// Whichever cluster comes first, the end is the same.
    void note(std::uint32_t vertex, std::uint32_t cluster) {
        std::uint32_t none = 0;
        if (!owner_[vertex].compare_exchange_strong(none, cluster + 1, std::memory_order_relaxed))
            owner_[vertex].store(kSeveral, std::memory_order_relaxed);
    }

    std::vector<std::atomic<std::uint32_t>> owner_;  // cluster + 1
};

class ClusterLinker {
public:
    ClusterLinker(const PreparedMesh& mesh, Partition& partition)
        : mesh_(mesh), partition_(partition), owners_(mesh, partition) {}

    std::uint32_t run() {
        std::vector<std::vector<OpenSide>> buckets(kBuckets);
        collect(buckets);
        std::vector<std::uint32_t> first_number(kBuckets + 1, 0);
        in_parallel(kBuckets, [&](std::size_t b) {
            std::sort(buckets[b].begin(), buckets[b].end());
            for_each_edge(buckets[b], [&](const OpenSide* begin, const OpenSide* end) {
                first_number[b + 1] += is_numbered(begin, end);
            });
        });
        for (std::size_t b = 0; b < kBuckets; ++b)
            first_number[b + 1] += first_number[b];
        in_parallel(kBuckets, [&](std::size_t b) {
            std::uint32_t number = first_number[b];
            for_each_edge(buckets[b], [&](const OpenSide* begin, const OpenSide* end) {
                link(begin, end, number);
            });
        });
        return first_number[kBuckets];
    }

private:
    std::uint32_t corner(std::uint32_t side) const {
        return mesh_.triangles[partition_.order[side / 3]][side % 3];
    }

    /// Two sides that begin at the same vertex.
    bool is_reversed(std::uint32_t side, std::uint32_t other) const {
        return other < Partition::kMany && corner(side) == corner(other);
    }

    void collect(std::vector<std::vector<OpenSide>>& buckets) const {
        const std::size_t clusters = partition_.ranges.size();
        const std::size_t parts = (clusters + kClustersOfPart - 1) / kClustersOfPart;
        std::vector<std::vector<OpenSide>> open(parts);
        in_parallel(parts, [&](std::size_t i) {
            const std::size_t last = std::min(clusters, (i + 1) * kClustersOfPart) - 1;
            const std::uint32_t end = partition_.ranges[last].end;
            open[i].reserve(kClustersOfPart * kSidesOfCluster);
            for (std::uint32_t p = partition_.ranges[i * kClustersOfPart].begin; p < end; ++p)
                collect_of_triangle(p, open[i]);
        });
        for (const std::vector<OpenSide>& sides : open)
            for (const OpenSide& side : sides)
                buckets[side.smaller * kBuckets / mesh_.size()].push_back(side);
    }

    void collect_of_triangle(std::uint32_t place, std::vector<OpenSide>& open) const {
        const Triangle& t = mesh_.triangles[partition_.order[place]];
        const bool shared[3] = {owners_.is_shared(t[0]), owners_.is_shared(t[1]),
                                owners_.is_shared(t[2])};
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t next = (k + 1) % 3, side = 3 * place + k;
            const std::uint32_t across = partition_.across[side];
            if (!(shared[k] && shared[next]) && !is_reversed(side, across) &&
                across != Partition::kNobody)
                continue;
            open.push_back({std::min(t[k], t[next]), std::max(t[k], t[next]), side});
        }
    }

    template <class Visit>
    static void for_each_edge(const std::vector<OpenSide>& sides, const Visit& visit) {
        const OpenSide* const last = sides.data() + sides.size();
        for (const OpenSide *begin = sides.data(), *end; begin != last; begin = end) {
            for (end = begin + 1; end != last && end->same_edge(*begin); ++end) {
            }
            visit(begin, end);
        }
    }

    bool is_numbered(const OpenSide* begin, const OpenSide* end) const {
        if (end - begin != 2) return false;
        const bool in_one_cluster = partition_.across[begin[0].side] == begin[1].side;
        return !in_one_cluster || is_reversed(begin[0].side, begin[1].side);
    }

    void link(const OpenSide* begin, const OpenSide* end, std::uint32_t& number) {
        if (end - begin == 2 && !is_numbered(begin, end)) return;  // as it is
        const bool is_edge = end - begin == 2;
        for (const OpenSide* side = begin; side != end; ++side)
            partition_.across[side->side] = is_edge ? kSharedEdge + number : Partition::kNobody;
        number += is_edge;
    }

    const PreparedMesh& mesh_;
    Partition& partition_;
    const VertexOwners owners_;
};

}  // namespace

std::uint32_t link_clusters(const PreparedMesh& mesh, Partition& partition) {
    return ClusterLinker(mesh, partition).run();
}

}  // namespace laplacian_lines
