// SPDX-License-Identifier: GPL-3.0-or-later
// Chains the segments of a batch to strips.
#pragma once

#include "redraw/simd/simd_kinds.h"
#include "redraw/simd/simd_segments.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// Means along whole lines are known where strips end, so no strip is much longer than √h.
constexpr unsigned kSegmentsOfPiece = 4;

class StripWriter {
public:
    StripWriter(const ClusterStore& store, const Batch& batch, const ActiveTriangles& active,
                const CrossingMemory& crossings, SegmentMemory& segments, unsigned count,
                StripOutput& output)
        : border_edges_(store.border_edges),
          batch_(batch),
          active_(active),
          crossings_(crossings),
          segments_(segments),
          count_(count),
          output_(output) {}

    void write_all(const LineRules& rules) {
        const unsigned most_segments = rules.whole ? kSegmentsOfPiece : kBatchTriangles;
        const unsigned firsts = link();
        unsigned written = 0;
        for (unsigned i = 0; i < firsts; ++i)
            written += write(segments_.first[i], most_segments);
        if (written < count_) write_loops(firsts, most_segments);
    }

private:
    /// Finds which segments go on, and which follow on none; returns the number of these.
    unsigned link() {
        SegmentMemory& s = segments_;
        for (unsigned i = 0; i < count_; ++i)  // all that is asked for
            s.ending[s.begin[i]] = s.next[i] = SegmentMemory::kNone;
        for (unsigned i = 0; i < count_; ++i)
            s.ending[s.triangle[i]] = std::uint16_t(i);
        constexpr unsigned nowhere = SegmentMemory::kPlaces - 1;
        unsigned firsts = 0;
        for (unsigned i = 0; i < count_; ++i) {
            const unsigned before = s.ending[s.begin[i]];
            const bool is_first = before == SegmentMemory::kNone;
            s.next[is_first ? nowhere : before] = std::uint16_t(i);
            s.first[firsts] = std::uint16_t(i);
            firsts += is_first;
        }
        return firsts;
    }

    const ActiveTriangle& triangle(unsigned segment) const {
        return active_.triangles[segments_.triangle[segment]];
    }

    /// The place in border_edges of the edge that a segment's neighbour is behind, if it leads out
    /// of the cluster. For name_edges(), since what lies there has to be waited for.
    std::uint32_t edge_to_elsewhere(unsigned neighbour) const {
        const Cluster& cluster = *batch_.clusters[neighbour / kNumbersOfSlot];
        const unsigned number = neighbour % kNumbersOfSlot;
        const bool leads_out = number >= cluster.triangle_count && number != kNoNeighbour;
        const std::uint32_t place = cluster.first_border_edge + number - cluster.triangle_count;
        __builtin_prefetch(&border_edges_[leads_out ? place : 0]);
        return leads_out ? place : Strip::kNoEdge;
    }

    void write_point(unsigned crossing, float slope, StripPoint* point) {
        store_row(load4(crossings_.points[crossing]), point->position);  // and the gradient
        point->slope = slope;
        point->opacity = crossings_.opacity[crossing];
    }

    /// Writes the strips that start with a segment, each of up to `most` segments; returns the
    /// number of their segments.
    unsigned write(unsigned first, unsigned most) {
        std::uint32_t edge = edge_to_elsewhere(triangle(first).previous);
        unsigned written = 0;
        for (unsigned next = first; next != SegmentMemory::kNone; edge = Strip::kContinued) {
            Strip& strip = output_.strips[output_.strip_count++];
            strip.first_point = output_.point_count;
            strip.edges[0] = edge;
            StripPoint* const points = output_.points + strip.first_point;
            StripPoint* point = points;
            write_point(segments_.begin[next], 0, point++);
            Float4 sums = {0, 0, 0, 0};
            unsigned last = next, left = most;
            for (; next != SegmentMemory::kNone && left > 0; next = segments_.next[next], --left) {
                write_point(segments_.triangle[next], segments_.slope[next], point++);
                sums += load4(segments_.sums[next]);
                last = next;
            }
            strip.edges[1] = next == SegmentMemory::kNone
                                 ? edge_to_elsewhere(triangle(last).successor)
                                 : Strip::kContinued;
            strip.point_count = std::uint32_t(point - points);
            output_.point_count += strip.point_count;
            strip.length = sums[0];
            strip.strength = sums[1];
            strip.slope = sums[2];
            strip.concave = sums[3];
            written += strip.point_count - 1;
        }
        return written;
    }

    /// What no strip has yet are lines that close within a cluster.
    void write_loops(unsigned firsts, unsigned most) {
        std::uint8_t written[kBatchTriangles];
        __builtin_memset(written, 0, count_);
        for (unsigned i = 0; i < firsts; ++i)
            for (unsigned j = segments_.first[i]; j != SegmentMemory::kNone; j = segments_.next[j])
                written[j] = 1;
        for (unsigned i = 0; i < count_; ++i) {
            if (written[i]) continue;
            unsigned last = i;
            for (written[i] = 1; segments_.next[last] != i; written[last] = 1)
                last = segments_.next[last];
            segments_.next[last] = SegmentMemory::kNone;  // cut open
            Strip& first = output_.strips[output_.strip_count];
            write(i, most);
            first.edges[0] = output_.strips[output_.strip_count - 1].edges[1] = Strip::kClosed;
        }
    }

    const std::uint32_t* border_edges_;
    const Batch& batch_;
    const ActiveTriangles& active_;
    const CrossingMemory& crossings_;
    SegmentMemory& segments_;
    const unsigned count_;
    StripOutput& output_;
};

/// Makes edges of places in border_edges, in strips from `begin` on.
static inline void name_edges(const ClusterStore& store, std::uint32_t begin,
                              const StripOutput& output) {
    for (std::uint32_t i = begin; i < output.strip_count; ++i)
        for (std::uint32_t& edge : output.strips[i].edges)
            if (edge < Strip::kContinued) edge = store.border_edges[edge];
}

/// Makes the places after crossings [0, count) something valid.
static inline void fill_up(CrossingMemory& m, std::size_t count) {
    __builtin_memset(m.ends[count], 0, kLanes * sizeof m.ends[0]);
}

/// Computes crossings [0, count) of a kind from their ends. As the functions that it calls, it
/// writes to whole vectors of places.
template <class Kinds, class Kind>
static inline void find_crossings(const ExtractionTask& task, const Batch& batch, unsigned kind,
                                  CrossingMemory& m, std::size_t count) {
    fill_up(m, count);
    find_shares(Kind::values(batch, kind), m, count);
    find_points(batch, Kind::source(task), m, count);
    Kind::test(task.kinds[Kinds::kFirst + kind].rules, task, batch, m, count);
}

/// Appends the strips of a kind in a batch, their edges for name_edges().
template <class Kinds, class Kind>
static inline void append_strips(const ClusterStore& store, const ExtractionTask& task,
                                 unsigned kind, SimdMemory& memory, StripOutput& output) {
    const Batch& batch = memory.batch;
    const ActiveTriangles& active = batch.active[kind];
    if (active.count == 0) return;
    const LineRules& rules = task.kinds[Kinds::kFirst + kind].rules;
    CrossingMemory& m = memory.crossings;
    SegmentMemory& s = memory.segments;
    find_crossings<Kinds, Kind>(task, batch, kind, m, list_crossings(active, m, s));
    unsigned count = active.count;
    if (rules.use_slope) {
        count = keep_accepted(m, s, count);
        if (count == 0) return;
        collect_corners(batch, active, Kind::values(batch, kind), m, s, count);
        test_segments<Kind::kSlope>(rules, s, count);
        count = keep_steep(rules, s, count);
    } else {
        count = keep_all(s, count);
        __builtin_memset(s.slope, 0, whole_vectors(count) * sizeof(float));
    }
    measure_segments(rules, m, s, count);
    StripWriter(store, batch, active, m, s, count, output).write_all(rules);
}

}  // namespace SIMD_SET
}  // namespace laplacian_lines
