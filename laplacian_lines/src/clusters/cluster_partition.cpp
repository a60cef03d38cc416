// SPDX-License-Identifier: GPL-3.0-or-later
// Clusters of neighbouring triangles: the mesh is cut near the median of its longest axis until a
// part has few enough triangles, vertices and edges to the outside; several threads take the parts
// after the first halvings. Then edges between clusters get numbers, at which a redraw joins lines.
#include "clusters/cluster_partition.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <utility>

#include "clusters/cluster_data.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kFewTriangles = 8192;  // not worth cutting for other threads
constexpr std::uint32_t kNoNumber = 0xffffffffu;

struct TriangleCentre {
    float at[3];  // times 3
    std::uint32_t triangle;
};

/// Numbers of vertices within one cluster after the other.
class LocalNumbers {
public:
    explicit LocalNumbers(std::size_t vertices) : number_(vertices, kNoNumber) {
        used_.reserve(kClusterVertices + 1);
    }

    void clear() {
        for (std::uint32_t v : used_)
            number_[v] = kNoNumber;
        used_.clear();
    }
    std::uint32_t of(std::uint32_t vertex) {
        std::uint32_t& number = number_[vertex];
        if (number == kNoNumber) {
            number = std::uint32_t(used_.size());
            used_.push_back(vertex);
        }
        return number;
    }
    std::size_t count() const { return used_.size(); }

private:
    std::vector<std::uint32_t> number_, used_;
};

class Partitioner {
public:
    Partitioner(const PreparedMesh& mesh, const CornerTable& sides, Partition& result)
        : mesh_(mesh),
          sides_(sides),
          result_(result),
          centres_(large_array<TriangleCentre>(mesh.triangles.size())),
          places_(mesh.triangles.size()),
          vertex_count_at_(mesh.triangles.size(), 0) {
        const std::size_t triangles = mesh.triangles.size();
        result.order = large_array<std::uint32_t>(triangles);
        result.corners = large_array<std::uint8_t>(3 * triangles);
        for_each_element(triangles, [&](std::size_t t) { centres_[t] = centre(std::uint32_t(t)); });
    }

    void run() {
        const auto all = std::uint32_t(centres_.size());
        const std::vector<Range> ranges = halve_in_parallel(
            Range{0, all}, kFewTriangles, [this](const Range& range) { return cut(range); });
        const std::size_t cuts = ranges.size() / 2, rest = ranges.size() - cuts;
        share(rest, workers_for(rest), [&](unsigned, Blocks& shared) {
            LocalNumbers numbers(mesh_.size());
            for (std::size_t i; shared.take(i);)
                split(ranges[cuts + i], numbers);
        });
        for (std::uint32_t i = 0; i < all; ++i) {
            if (vertex_count_at_[i] == 0) continue;
            if (!result_.ranges.empty()) result_.ranges.back().end = i;
            result_.ranges.push_back({i, all, vertex_count_at_[i]});
        }
        result_.places.assign(places_.begin(), places_.end());
    }

private:
    /// A range of places in centres_.
    struct Range {
        std::uint32_t begin, end;
        std::uint32_t size() const { return end - begin; }
    };
    TriangleCentre centre(std::uint32_t t) const {
        const Triangle& corners = mesh_.triangles[t];
        const Eigen::Vector3f sum = (mesh_.positions[corners[0]] + mesh_.positions[corners[1]] +
                                     mesh_.positions[corners[2]])
                                        .cast<float>();
        return {{sum.x(), sum.y(), sum.z()}, t};
    }

    void split(const Range& range, LocalNumbers& numbers) {
        if (range.size() <= kClusterTriangles && becomes_cluster(range, numbers)) return;
        const auto [left, right] = cut(range);
        split(left, numbers);
        split(right, numbers);
    }

    std::pair<Range, Range> cut(const Range& range) {
        // Full clusters on the left keep all but the last ones full.
        const std::uint32_t half = range.size() / 2;
        const std::uint32_t full = half / kClusterTriangles * kClusterTriangles;
        const std::uint32_t middle = range.begin + (full > 0 ? full : half);
        order_by_longest_axis(range.begin, middle, range.end);
        return {{range.begin, middle}, {middle, range.end}};
    }

    void order_by_longest_axis(std::uint32_t begin, std::uint32_t middle, std::uint32_t end) {
        Eigen::AlignedBox3f box;
        for (std::uint32_t i = begin; i < end; ++i)
            box.extend(Eigen::Map<const Eigen::Vector3f>(centres_[i].at));
        int axis;
        box.sizes().maxCoeff(&axis);
        std::nth_element(
            centres_.begin() + begin, centres_.begin() + middle, centres_.begin() + end,
            [axis](const TriangleCentre& a, const TriangleCentre& b) {
                return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.triangle < b.triangle;
            });
    }

    /// Makes the range a cluster, unless it has too many vertices or numbers, see kClusterNumbers.
    bool becomes_cluster(const Range& range, LocalNumbers& numbers) {
        const auto [begin, end] = range;
        std::uint32_t* order = result_.order.data();
        for (std::uint32_t i = begin; i < end; ++i)
            order[i] = centres_[i].triangle;
        std::sort(order + begin, order + end);  // the input's order often has some sense
        std::uint8_t* corners = result_.corners.data() + 3 * std::size_t(begin);
        numbers.clear();
        for (std::uint32_t i = begin; i < end; ++i) {
            places_[order[i]].store(i, std::memory_order_relaxed);
            for (std::uint32_t v : mesh_.triangles[order[i]]) {
                const std::uint32_t number = numbers.of(v);
                if (number >= kClusterVertices) return false;
                *corners++ = std::uint8_t(number);
            }
        }
        if (count_numbers(range) > kClusterNumbers) return false;
        vertex_count_at_[begin] = std::uint8_t(numbers.count());
        return true;
    }

    /// How many numbers a cluster takes at most: borders are counted, although they have none. A
    /// disc has 2 · vertices − 2 with them, which is never too many.
    unsigned count_numbers(const Range& range) const {
        unsigned numbers = range.size();
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            for (std::uint32_t side = 3 * result_.order[i], k = 0; k < 3; ++side, ++k) {
                const std::uint32_t across = sides_.across(side);
                if (across == CornerTable::kMany) continue;
                numbers += across == CornerTable::kBorder || !is_in(range, across / 3) ||
                           !have_one_orientation(mesh_.triangles, side, across);
            }
        return numbers;
    }

    /// The place of a triangle may be from a range tried before, and another one's by now.
    bool is_in(const Range& range, std::uint32_t triangle) const {
        const std::uint32_t place = places_[triangle].load(std::memory_order_relaxed);
        return place >= range.begin && place < range.end && result_.order[place] == triangle;
    }

    const PreparedMesh& mesh_;
    const CornerTable& sides_;
    Partition& result_;
    std::vector<TriangleCentre> centres_;
    std::vector<std::atomic<std::uint32_t>> places_;  // by triangle, of the last try
    std::vector<std::uint8_t> vertex_count_at_;       // of the cluster that begins at a place, or 0
};

}  // namespace

Partition partition(const PreparedMesh& mesh, const CornerTable& sides) {
    Partition result;
    if (!mesh.triangles.empty()) Partitioner(mesh, sides, result).run();
    return result;
}

ClusterLinks link_clusters(const PreparedMesh& mesh, const CornerTable& sides,
                           const Partition& partition) {
    ClusterLinks links;
    links.across = large_array(sides.side_count(), ClusterLinks::kNobody);
    for (const ClusterRange& range : partition.ranges)
        for (std::uint32_t here = 3 * range.begin; here < 3 * range.end; ++here) {
            const std::uint32_t side = 3 * partition.order[here / 3] + here % 3;
            if (!sides.has_neighbour(side)) continue;
            const std::uint32_t across = sides.across(side), place = partition.places[across / 3];
            if (place >= range.begin && place < range.end &&
                have_one_orientation(mesh.triangles, side, across))
                links.across[here] = place;  // a redraw goes on there; else at the number
            else if (const std::uint32_t other = 3 * place + across % 3; here < other)
                links.across[here] = links.across[other] =
                    ClusterLinks::kNumber + links.number_count++;
        }
    return links;
}

}  // namespace laplacian_lines
