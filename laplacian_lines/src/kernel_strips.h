// SPDX-License-Identifier: GPL-3.0-or-later
// Chains the segments of a cluster to strips.
// Included once by each of the files cluster_kernels_*.cpp.
#pragma once

#include "kernel_segments.h"

namespace laplacian_lines {
namespace KERNEL_NAMESPACE {

class StripWriter {
public:
    StripWriter(const ClusterStore& store, const SignedCluster& signs, StripKind kind,
                const CrossingMemory& crossings, SegmentMemory& segments, unsigned count,
                StripOutput& output)
        : cluster_(*signs.cluster),
          border_edges_(store.border_edges + signs.cluster->first_border_edge),
          active_(signs.active[kind]),
          crossings_(crossings),
          segments_(segments),
          count_(count),
          output_(output) {}

    /// `listed`: segment_of_triangle is that of list_crossings(), since no segment was left out.
    void write_all(bool listed) {
        link(listed);
        unsigned written = 0;
        for (unsigned i = 0; i < count_; ++i)
            if (previous(i) == kNoNeighbour) written += write(i);
        if (written < count_) write_loops();
    }

private:
    void link(bool listed) {
        std::uint8_t* segment = segments_.segment_of_triangle;
        if (!listed) {
            __builtin_memset(segment, kNoNeighbour, sizeof(segments_.segment_of_triangle));
            for (unsigned i = 0; i < count_; ++i)
                segment[triangle(i).number] = std::uint8_t(i);
        }
        for (unsigned i = 0; i < count_; ++i)
            segments_.next[i] = segment[triangle(i).successor];
    }

    const ActiveTriangle& triangle(unsigned segment) const {
        return active_[segments_.triangle[segment]];
    }
    unsigned previous(unsigned segment) const {
        return segments_.segment_of_triangle[triangle(segment).previous];
    }

    /// The edge of the mesh behind a neighbour's number, if it leads out of the cluster.
    std::uint32_t edge_to_elsewhere(unsigned neighbour) const {
        const bool leads_out = neighbour >= cluster_.triangle_count && neighbour != kNoNeighbour;
        return leads_out ? border_edges_[neighbour - cluster_.triangle_count] : Strip::kNoEdge;
    }

    void add_point(unsigned crossing, float slope) {
        StripPoint& point = output_.points[output_.point_count++];
        store_row(load4(crossings_.points[crossing]), point.position);  // and the gradient
        point.slope = slope;
        point.opacity = crossings_.opacity[crossing];
    }

    /// Writes the strip that starts with a segment; returns its number of segments.
    unsigned write(unsigned first) {
        Strip& strip = output_.strips[output_.strip_count++];
        strip.first_point = output_.point_count;
        strip.edges[0] = edge_to_elsewhere(triangle(first).previous);
        add_point(segments_.begin[first], 0);
        Float4 sums = {0, 0, 0, 0};
        unsigned last = first;
        for (unsigned i = first; i != kNoNeighbour; i = segments_.next[i]) {
            add_point(segments_.triangle[i], segments_.slope[i]);
            sums += load4(segments_.sums[i]);
            last = i;
        }
        strip.edges[1] = edge_to_elsewhere(triangle(last).successor);
        strip.point_count = output_.point_count - strip.first_point;
        strip.length = sums[0];
        strip.strength = sums[1];
        strip.slope = sums[2];
        return strip.point_count - 1;
    }

    /// What no strip has yet are lines that close within the cluster.
    void write_loops() {
        std::uint8_t written[kClusterTriangles] = {};
        for (unsigned i = 0; i < count_; ++i)
            if (previous(i) == kNoNeighbour)
                for (unsigned j = i; j != kNoNeighbour; j = segments_.next[j])
                    written[j] = 1;
        for (unsigned i = 0; i < count_; ++i) {
            if (written[i]) continue;
            unsigned last = i;
            for (written[i] = 1; segments_.next[last] != i; written[last] = 1)
                last = segments_.next[last];
            segments_.next[last] = kNoNeighbour;  // cut open
            Strip& strip = output_.strips[output_.strip_count];
            write(i);
            strip.edges[0] = strip.edges[1] = Strip::kClosed;
        }
    }

    const Cluster& cluster_;
    const std::uint32_t* border_edges_;
    const ActiveTriangle* active_;
    const CrossingMemory& crossings_;
    SegmentMemory& segments_;
    const unsigned count_;
    StripOutput& output_;
};

/// Appends the strips of one function in one cluster.
static inline void find_strips(const ClusterStore& store, const ExtractionTask& task,
                               const SignedCluster& signs, StripKind kind, KernelMemory& memory,
                               StripOutput& output) {
    if (signs.count[kind] == 0) return;
    const Cluster& cluster = *signs.cluster;
    const auto* records = reinterpret_cast<const VertexRecord*>(memory_of(store, cluster) +
                                                                cluster_layout(cluster).records);
    CrossingMemory& m = memory.crossings;
    SegmentMemory& s = memory.segments;
    const unsigned crossings = list_crossings(signs.active[kind], signs.count[kind], m, s);
    find_crossings(records, task, signs, kind, m, crossings);
    unsigned count = signs.count[kind];
    if (task.rules[kind].use_slope) {
        count = keep_accepted(m, s, count);
        if (count == 0) return;
        collect_corners(records, signs, m, s, count);
        test_segments(task.rules[kind], s, count);
        count = keep_steep(s, count);
    } else {  // all are kept, also by find_crossings()
        __builtin_memset(s.slope, 0, whole_vectors(count) * sizeof(float));
        for (unsigned i = count; i < count + kLanes; ++i)  // something valid
            s.triangle[i] = s.begin[i] = 0;
    }
    measure_segments(m, s, count);
    StripWriter(store, signs, kind, m, s, count, output).write_all(!task.rules[kind].use_slope);
}

}  // namespace KERNEL_NAMESPACE
}  // namespace laplacian_lines
