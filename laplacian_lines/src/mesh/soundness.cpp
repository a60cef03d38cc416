// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/soundness.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "laplacian_lines/mesh_faults.h"
#include "mesh/stitching.h"

namespace laplacian_lines {
namespace {

/// Shares of the edges; open surfaces of a few hundred triangles have borders of 5 %.
constexpr double kMostBorders = 0.2, kMostOpposed = 0.02;
/// A surface that does not close up but for holes has no inside, nor has one that holds no volume.
constexpr double kMostBordersOfHoles = 0.02, kMostOpen = 0.1, kLeastVolume = 0.02;
/// Angle, in radians, by which most of the surface turns within the kernel.
constexpr double kMostBend = 0.7;

struct EdgeCounts {
    std::atomic<std::size_t> edges{0}, borders{0}, opposed{0};
};

/// A side of a triangle, of its smaller vertex: the larger one, and which of them comes first.
struct Side {
    std::uint32_t to;
    bool is_forward;

    bool operator<(const Side& other) const { return to < other.to; }
};

template <class Visit>
void for_each_side(const VertexRanges::Range& range, Visit visit) {
    range.for_each_triangle([&](const Triangle& t) {
        for (unsigned k = 0; k < 3; ++k) {
            const auto [smaller, larger] = std::minmax(t[k], t[(k + 1) % 3]);
            if (range.holds(smaller)) visit(smaller - range.begin(), larger, t[k] == smaller);
        }
    });
}

/// Sorts the few edges of one vertex after the other.
void count_edges(const VertexRanges::Range& range, EdgeCounts& counts) {
    std::vector<std::uint32_t> ends(range.end() - range.begin(), 0);
    for_each_side(range, [&](std::uint32_t from, std::uint32_t, bool) { ++ends[from]; });
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<Side> sides(ends.back());
    std::vector<std::uint32_t> begins = ends;
    for_each_side(range, [&](std::uint32_t from, std::uint32_t to, bool is_forward) {
        sides[--begins[from]] = {to, is_forward};
    });
    std::size_t edges = 0, borders = 0, opposed = 0;
    for (std::size_t v = 0; v < ends.size(); ++v) {
        const auto last = sides.begin() + ends[v];
        std::sort(sides.begin() + begins[v], last);
        for (auto begin = sides.begin() + begins[v], end = begin; begin != last; begin = end) {
            end = std::find_if(begin, last, [&](const Side& side) { return side.to != begin->to; });
            ++edges;
            if (end - begin == 1) ++borders;
            if (end - begin == 2 && begin[0].is_forward == begin[1].is_forward) ++opposed;
        }
    }
    counts.edges += edges, counts.borders += borders, counts.opposed += opposed;
}

struct Sums {
    Eigen::Vector3d area_vectors = Eigen::Vector3d::Zero();
    double area = 0, volume = 0;

    void add(const Eigen::Vector3d& vector, double a, double v) {
        area_vectors += vector;
        area += a;
        volume += v;
    }
};

Sums add_up(const PreparedMesh& mesh) {
    const auto of_block = [&](std::size_t begin, std::size_t end) {
        Sums sums;
        for (std::size_t i = begin; i < end; ++i) {
            const Triangle& t = mesh.triangles[i];
            const Eigen::Vector3d vector = area_vector(mesh, t);
            sums.add(vector, vector.norm(), mesh.positions[t[0]].dot(vector));
        }
        return sums;
    };
    return join_blocks(mesh.triangles.size(), Sums(), of_block, [](Sums a, const Sums& b) {
        a.add(b.area_vectors, b.area, b.volume);
        return a;
    });
}

double share(std::size_t part, std::size_t whole) {
    return whole ? double(part) / double(whole) : 0;
}

}  // namespace

void measure_soundness(const PreparedMesh& mesh, const VertexRanges& ranges, MeshReport& report) {
    if (!is_closed(mesh.triangles)) {
        EdgeCounts counts;
        const Progress nobody;
        ranges.for_each({nobody, 0, 1, ""}, [&](const auto& range) { count_edges(range, counts); });
        report.border_share = share(counts.borders, counts.edges);
        report.opposed_share = share(counts.opposed, counts.edges);
    }
    const Sums sums = add_up(mesh);
    report.openness = sums.area_vectors.norm() / sums.area;
    report.relative_volume = sums.volume / sums.area;
}

std::vector<MeshFault> faults_of(const MeshReport& report) {
    std::vector<MeshFault> faults;
    if (report.border_share > kMostBorders) faults.push_back(MeshFault::Torn);
    if (report.opposed_share > kMostOpposed) faults.push_back(MeshFault::Disagreeing);
    if (!faults.empty()) return faults;  // which hide the others
    if (report.border_share < kMostBordersOfHoles && report.openness < kMostOpen &&
        report.relative_volume < -kLeastVolume)
        faults.push_back(MeshFault::InsideOut);
    if (report.kernel_bend > kMostBend) faults.push_back(MeshFault::CoarseKernel);
    return faults;
}

}  // namespace laplacian_lines
