// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/cluster_partition.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "clusters/cluster_data.h"
#include "system/halving.h"
#include "system/large_array.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kFewTriangles = 8192;  // not worth cutting for other threads
constexpr unsigned kBins = 1024;
constexpr std::uint32_t kNoNumber = 0xffffffffu;

struct TriangleCentre {
    float at[3];  // times 3
    std::uint32_t triangle;
};

/// Equal parts of an axis.
struct Bins {
    int axis;
    float begin, scale;

    unsigned of(const TriangleCentre& centre) const {
        return std::min(unsigned((centre.at[axis] - begin) * scale), kBins - 1);
    }
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

/// Pairs the sides of one cluster.
class SidePairing {
public:
    /// `corners` of `triangles`, which are at most kClusterVertices, and which of them are coarse.
    /// Writes across[side] as in Partition, plus `first_side`. Returns how many numbers (see
    /// kClusterNumbers) it may take.
    unsigned pair(const std::uint8_t* corners, const std::uint8_t* coarse, unsigned triangles,
                  std::uint32_t first_side, std::uint32_t* across) {
        sort_sides(corners, 3 * triangles);
        unsigned numbers = triangles;
        for (unsigned begin = 0, end; begin < 3 * triangles; begin = end) {
            for (end = begin + 1; end < 3 * triangles && same_edge(begin, end); ++end) {
            }
            numbers += link(begin, end, corners, coarse, first_side, across);
        }
        return numbers;
    }

private:
    struct Side {
        std::uint8_t smaller, larger;  // corners
        std::uint16_t number;
    };

    static unsigned next(unsigned side) { return side % 3 == 2 ? side - 2 : side + 1; }

    /// By corners; equal ones by number.
    void sort_sides(const std::uint8_t* corners, unsigned count) {
        std::uint16_t start[kClusterVertices + 1] = {};
        for (unsigned s = 0; s < count; ++s)
            ++start[std::min(corners[s], corners[next(s)]) + 1];
        for (unsigned v = 0; v < kClusterVertices; ++v)
            start[v + 1] = std::uint16_t(start[v + 1] + start[v]);
        std::uint16_t fill[kClusterVertices];
        std::copy(start, start + kClusterVertices, fill);
        for (unsigned s = 0; s < count; ++s) {
            const auto [a, b] = std::minmax(corners[s], corners[next(s)]);
            unsigned place = fill[a]++;
            for (; place > start[a] && sides_[place - 1].larger > b; --place)
                sides_[place] = sides_[place - 1];
            sides_[place] = {a, b, std::uint16_t(s)};
        }
    }

    bool same_edge(unsigned i, unsigned j) const {
        return sides_[i].smaller == sides_[j].smaller && sides_[i].larger == sides_[j].larger;
    }

    /// The sides of one edge. Returns how many of them may need a number.
    unsigned link(unsigned begin, unsigned end, const std::uint8_t* corners,
                  const std::uint8_t* coarse, std::uint32_t first_side,
                  std::uint32_t* across) const {
        const unsigned count = end - begin;
        if (count != 2) {
            for (unsigned i = begin; i < end; ++i)
                across[sides_[i].number] = count == 1 ? Partition::kNobody : Partition::kMany;
            return count == 1;
        }
        const unsigned a = sides_[begin].number, b = sides_[begin + 1].number;
        if (coarse[a / 3] != coarse[b / 3]) {
            across[a] = across[b] = Partition::kNobody;
            return 2;
        }
        across[a] = first_side + b;
        across[b] = first_side + a;
        return corners[a] == corners[b] ? 2 : 0;  // of opposite orientation
    }

    Side sides_[3 * kClusterTriangles];
};

class Partitioner {
public:
    Partitioner(const PreparedMesh& mesh, const std::vector<std::uint8_t>& coarse,
                Partition& result)
        : mesh_(mesh),
          coarse_(coarse),
          result_(result),
          centres_(large_array<TriangleCentre>(mesh.triangles.size())),
          spare_(large_array<TriangleCentre>(mesh.triangles.size())),
          vertex_count_at_(mesh.triangles.size(), 0) {
        const std::size_t triangles = mesh.triangles.size();
        result.order = large_array<std::uint32_t>(triangles);
        result.corners = large_array<std::uint8_t>(3 * triangles);
        result.across = large_array<std::uint32_t>(3 * triangles);
        in_blocks(triangles, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t)
                centres_[t] = centre(std::uint32_t(t));
        });
    }

    void run() {
        const auto all = std::uint32_t(centres_.size());
        const std::vector<Range> ranges = halve_in_parallel(
            Range{0, all}, kFewTriangles, [this](const Range& range) { return cut(range); });
        const std::size_t cuts = ranges.size() / 2, rest = ranges.size() - cuts;
        share(rest, workers_for(rest), [&](unsigned, Blocks& shared) {
            Worker worker(mesh_.size());
            for (std::size_t i; shared.take(i);)
                split(ranges[cuts + i], worker);
        });
        for (std::uint32_t i = 0; i < all; ++i) {
            if (vertex_count_at_[i] == 0) continue;
            if (!result_.ranges.empty()) result_.ranges.back().end = i;
            result_.ranges.push_back({i, all, vertex_count_at_[i]});
        }
    }

private:
    /// A range of places in centres_.
    struct Range {
        std::uint32_t begin, end;
        std::uint32_t size() const { return end - begin; }
    };
    struct Worker {
        explicit Worker(std::size_t vertices) : numbers(vertices) {}
        LocalNumbers numbers;
        SidePairing pairing;
        std::uint8_t coarse[kClusterTriangles];  // of the cluster that is tried
    };

    TriangleCentre centre(std::uint32_t t) const {
        const Triangle& corners = mesh_.triangles[t];
        const Eigen::Vector3f sum = (mesh_.positions[corners[0]] + mesh_.positions[corners[1]] +
                                     mesh_.positions[corners[2]])
                                        .cast<float>();
        return {{sum.x(), sum.y(), sum.z()}, t};
    }

    void split(const Range& range, Worker& worker) {
        if (range.size() <= kClusterTriangles && becomes_cluster(range, worker)) return;
        const auto [left, right] = cut(range);
        split(left, worker);
        split(right, worker);
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
        const float length = box.sizes().maxCoeff(&axis);
        const Bins bins = {axis, box.min()[axis], float(kBins) / length};
        std::uint32_t low = begin, high = end;  // of those in the bin of the middle
        if (std::isfinite(bins.scale)) divide(bins, middle, low, high);
        std::nth_element(centres_.begin() + low, centres_.begin() + middle, centres_.begin() + high,
                         [axis](const TriangleCentre& a, const TriangleCentre& b) {
                             return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis]
                                                             : a.triangle < b.triangle;
                         });
    }

    /// Puts those in lower bins than the middle's first and those in higher ones last, without
    /// branches that a processor could not foresee. `low` and `high` close in on the others.
    void divide(const Bins& bins, std::uint32_t middle, std::uint32_t& low, std::uint32_t& high) {
        const std::uint32_t begin = low, end = high;
        std::uint32_t counts[kBins] = {};
        for (std::uint32_t i = begin; i < end; ++i)
            ++counts[bins.of(centres_[i])];
        unsigned bin = 0;
        for (std::uint32_t before = begin; before + counts[bin] <= middle; ++bin)
            before += counts[bin];
        std::uint32_t right = begin, others = end;  // written to spare_ upwards and downwards
        for (std::uint32_t i = begin; i < end; ++i) {
            const TriangleCentre centre = centres_[i];
            const unsigned its = bins.of(centre);
            if (its == bin) {
                spare_[--others] = centre;
                continue;
            }
            centres_[low] = spare_[right] = centre;
            low += its < bin;
            right += its > bin;
        }
        high = end - (right - begin);
        std::copy(spare_.begin() + others, spare_.begin() + end, centres_.begin() + low);
        std::copy(spare_.begin() + begin, spare_.begin() + right, centres_.begin() + high);
    }

    /// Unless the triangles exceed a cluster's numbers of vertices or of numbers.
    bool becomes_cluster(const Range& range, Worker& worker) {
        const auto [begin, end] = range;
        std::uint32_t* order = result_.order.data();
        for (std::uint32_t i = begin; i < end; ++i)
            order[i] = centres_[i].triangle;
        std::sort(order + begin, order + end);  // the input's order often has some sense
        std::uint8_t* corners = result_.corners.data() + 3 * std::size_t(begin);
        worker.numbers.clear();
        for (std::uint32_t i = begin; i < end; ++i)
            for (std::uint32_t v : mesh_.triangles[order[i]]) {
                const std::uint32_t number = worker.numbers.of(v);
                if (number >= kClusterVertices) return false;
                *corners++ = std::uint8_t(number);
            }
        for (std::uint32_t i = begin; i < end; ++i)
            worker.coarse[i - begin] = coarse_[order[i]];
        const std::size_t first_side = 3 * std::size_t(begin);
        if (worker.pairing.pair(result_.corners.data() + first_side, worker.coarse, end - begin,
                                std::uint32_t(first_side),
                                result_.across.data() + first_side) > kClusterNumbers)
            return false;
        vertex_count_at_[begin] = std::uint8_t(worker.numbers.count());
        return true;
    }

    const PreparedMesh& mesh_;
    const std::vector<std::uint8_t>& coarse_;
    Partition& result_;
    std::vector<TriangleCentre> centres_, spare_;
    std::vector<std::uint8_t> vertex_count_at_;  // of the cluster that begins at a place, or 0
};

}  // namespace

Partition partition(const PreparedMesh& mesh, const std::vector<std::uint8_t>& coarse) {
    Partition result;
    if (!mesh.triangles.empty()) Partitioner(mesh, coarse, result).run();
    return result;
}

}  // namespace laplacian_lines
