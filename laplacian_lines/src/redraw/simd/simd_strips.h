// SPDX-License-Identifier: GPL-3.0-or-later
// Segments of lines in single triangles, their tests, and strips of those that are kept.
#pragma once

#include "redraw/simd/simd_kinds.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// Lists the crossings of a batch's active triangles. A triangle owns the crossing where its line
/// leaves, which gets the triangle's place; the one where the line enters is that of the triangle
/// before, or one of its own if that one is elsewhere. Returns the number of crossings; what is
/// done with them writes to whole vectors of places.
static inline unsigned list_crossings(const ActiveTriangles& active, CrossingMemory& m,
                                      SegmentMemory& s) {
    const auto list = [&](unsigned crossing, const std::uint16_t ends[2]) {
        __builtin_memcpy(m.ends[crossing], ends, sizeof m.ends[0]);
    };
    for (unsigned i = 0; i < active.count; ++i)  // those that are looked up below
        s.in_triangle[active.triangles[i].previous] = SegmentMemory::kNone;
    for (unsigned i = 0; i < active.count; ++i) {
        s.in_triangle[active.triangles[i].own] = std::uint16_t(i);
        list(i, active.triangles[i].exit);
    }
    unsigned crossings = active.count;
    for (unsigned i = 0; i < active.count; ++i) {  // without branches, which would be guessed wrong
        const unsigned previous = s.in_triangle[active.triangles[i].previous];
        const bool own = previous == SegmentMemory::kNone;
        list(crossings, active.triangles[i].entry);
        s.begin[i] = std::uint16_t(own ? crossings : previous);
        crossings += own;
    }
    __builtin_memset(m.ends[crossings], 0, kLanes * sizeof m.ends[0]);  // something valid
    return crossings;
}

/// Puts something valid behind `count` segments, for whole vectors; returns `count`.
static inline unsigned padded(SegmentMemory& s, unsigned count) {
    for (unsigned i = count; i < count + kLanes; ++i)
        s.triangle[i] = s.begin[i] = 0;
    return count;
}

/// Leaves out segments with a refused crossing; returns how many are left.
static inline unsigned keep_accepted(const CrossingMemory& m, SegmentMemory& s, unsigned count) {
    unsigned kept = 0;
    for (unsigned first = 0; first < count; first += 64) {
        std::uint64_t ends = m.accepted[first / 64];
        if (count - first < 64) ends &= ~(~std::uint64_t(0) << (count - first));
        for (; ends; ends &= ends - 1) {
            const unsigned i = first + unsigned(__builtin_ctzll(ends)), begin = s.begin[i];
            s.triangle[kept] = std::uint16_t(i);
            s.begin[kept] = std::uint16_t(begin);
            kept += m.accepted[begin / 64] >> begin % 64 & 1;
        }
    }
    return padded(s, kept);
}

/// Keeps all segments; the counterpart of keep_accepted().
static inline unsigned keep_all(SegmentMemory& s, unsigned count) {
    for (unsigned i = 0; i < count; ++i)
        s.triangle[i] = std::uint16_t(i);
    return padded(s, count);
}

/// Sums over segments [0, count), whose slopes are known; strength: Eq. 4.
static inline void measure_segments(const LineRules& rules, const CrossingMemory& m,
                                    SegmentMemory& s, std::size_t count) {
    const auto mean = [&](std::size_t i) {
        return (m.concave[s.begin[i]] + m.concave[s.triangle[i]]) / 2;
    };
    for (std::size_t i = 0; i < count; i += 4) {
        Float4 rows[4];
        for (unsigned k = 0; k < 4; ++k) {
            const Float4 a = load4(m.points[s.begin[i + k]]),
                         b = load4(m.points[s.triangle[i + k]]);
            rows[k] = shuffle<0, 1, 2, 7>(b - a, a + b);
        }
        transpose(rows);
        const Float4 x = rows[0], y = rows[1], z = rows[2], gradients = rows[3];
        const Float4 length = square_root(x * x + y * y + z * z);
        const Float4 slope = load4(s.slope + i);
        rows[0] = length;
        rows[1] = gradients / 2 * length;
        rows[2] = slope * length;
        rows[3] = rules.whole && rules.concave_only
                      ? Float4{mean(i), mean(i + 1), mean(i + 2), mean(i + 3)} * length
                      : Float4{0, 0, 0, 0};
        transpose(rows);
        for (unsigned k = 0; k < 4; ++k)
            store4(s.sums[i + k], rows[k]);
    }
}

/// Collects what test_segments() needs as columns.
static inline void collect_corners(const Batch& batch, const ActiveTriangles& active,
                                   const float* function, const CrossingMemory& m, SegmentMemory& s,
                                   unsigned count) {
    for (unsigned i = 0; i < count; i += 4) {
        Float4 u[4], v[4];
        for (unsigned k = 0; k < 4; ++k) {
            const unsigned place = s.triangle[i + k];
            const ActiveTriangle& t = active.triangles[place];
            const RecordsOfSlot records = records_around(batch, t.third);
            const Float4 a = load4(position_at(records, t.exit[0])),
                         b = load4(position_at(records, t.exit[1])),
                         c = load4(position_at(records, t.third));
            u[k] = b - a;
            v[k] = c - a;
            for (int axis = 0; axis < 3; ++axis)
                s.g[axis][i + k] = m.g[axis][s.begin[i + k]] + m.g[axis][place];
            s.fu[i + k] = m.above[place] - m.below[place];
            s.fv[i + k] = function[t.third] - m.below[place];
        }
        transpose(u);
        transpose(v);
        store_columns(u, s.u[0] + i, s.u[1] + i, s.u[2] + i);
        store_columns(v, s.v[0] + i, s.v[1] + i, s.v[2] + i);
    }
}

/// Slope of the function across the line, and whether the illumination's gradient is largest
/// there (edge) or smallest (phantom). Refused segments get the slope −1.
template <SegmentSlope Slope>
static inline void test_segments(const LineRules& rules, SegmentMemory& s, std::size_t count) {
    const float largest = rules.reject_phantoms ? 0 : FLT_MAX;
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Vectors u = load_vectors(s.u, i), v = load_vectors(s.v, i), n = cross(u, v);
        // ∇f of the linear interpolant: (fu·(v × N) + fv·(N × u)) / |N|², N = u × v.
        const Vectors f = cross(v, n) * load(s.fu + i) + cross(n, u) * load(s.fv + i);
        const Floats squared = dot(n, n), product = dot(f, load_vectors(s.g, i));
        if (Slope != SegmentSlope::Scaled) {
            const Floats change = -product / (2 * squared);  // d summed over both ends
            const Floats size = absolute(change);
            const Floats powered = Slope == SegmentSlope::Along ? size * square_root(size) : size;
            const Floats slope = powered * rules.slope_scale;
            // of full width it cannot have more: single steep segments decide no mean
            const Floats most = at_most(slope, rules.segment_slope + rules.full_slope);
            const Ints kept = (slope >= rules.segment_slope) & (change > 0);
            if (rules.whole)  // nothing of a sliver's NaN
                store(s.slope + i, change > 0 ? most : (change <= 0 ? -most : Floats{}));
            else
                store(s.slope + i, kept ? most : Floats{} - 1);
            continue;
        }
        const Floats steepness = square_root(dot(f, f)) / squared;
        const Floats slope = steepness * rules.slope_scale;
        if (rules.whole) {  // nothing of a sliver's NaN
            store(s.slope + i, slope >= 0 ? (product <= largest ? slope : -slope) : Floats{});
            continue;
        }
        // Comparisons with a sliver's NaN are false.
        const Ints kept = (slope >= rules.segment_slope) & (product <= largest);
        store(s.slope + i, kept ? slope : Floats{} - 1);
    }
}

/// Leaves out refused segments, of which whole lines have none; returns how many are left.
static inline unsigned keep_steep(const LineRules& rules, SegmentMemory& s, unsigned count) {
    if (rules.whole) return count;
    unsigned kept = 0;
    for (unsigned i = 0; i < count; ++i) {
        s.triangle[kept] = s.triangle[i];
        s.begin[kept] = s.begin[i];
        s.slope[kept] = s.slope[i];
        kept += s.slope[i] >= 0;
    }
    return padded(s, kept);
}

// ---- strips ----

/// Means along whole lines are known where strips end, so these are only some √h apart.
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
        __builtin_memset(segments_.is_written, 0, count_);
        for (unsigned i = 0; i < firsts; ++i)
            write(segments_.first[i], most_segments);
        for (unsigned i = 0; i < count_; ++i)
            if (!segments_.is_written[i]) write_loop(i, most_segments);
    }

private:
    /// Finds which segments go on, and which follow on none; returns the number of these.
    unsigned link() {
        SegmentMemory& s = segments_;
        for (unsigned i = 0; i < count_; ++i)  // those that are looked up below
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

    /// The edge that a segment's neighbour is behind, if it leads out of the cluster.
    std::uint32_t edge_to_elsewhere(unsigned neighbour) const {
        const Cluster& cluster = *batch_.clusters[neighbour / kNumbersOfSlot];
        const unsigned number = neighbour % kNumbersOfSlot;
        const bool leads_out = number >= cluster.triangle_count && number != kNoNeighbour;
        return leads_out
                   ? border_edges_[cluster.first_border_edge + number - cluster.triangle_count]
                   : Strip::kNoEdge;
    }

    void write_point(unsigned crossing, float slope, StripPoint* point) {
        const Float4 row = load4(crossings_.points[crossing]);
        store_row(row, point->position);
        point->slope = slope;
        point->gradient = row[3];
        point->opacity = crossings_.opacity[crossing];
    }

    /// Writes the strips that start with a segment, each of up to `most` segments.
    void write(unsigned first, unsigned most) {
        std::uint32_t edge = edge_to_elsewhere(triangle(first).previous);
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
                segments_.is_written[next] = true;
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
        }
    }

    /// A line that closes within a cluster: what no strip has otherwise.
    void write_loop(unsigned begin, unsigned most) {
        unsigned last = begin;
        while (segments_.next[last] != begin)
            last = segments_.next[last];
        segments_.next[last] = SegmentMemory::kNone;  // cut open
        Strip& first = output_.strips[output_.strip_count];
        write(begin, most);
        first.edges[0] = output_.strips[output_.strip_count - 1].edges[1] = Strip::kClosed;
    }

    const std::uint32_t* border_edges_;
    const Batch& batch_;
    const ActiveTriangles& active_;
    const CrossingMemory& crossings_;
    SegmentMemory& segments_;
    const unsigned count_;
    StripOutput& output_;
};

/// Appends the strips of a kind in a batch.
template <class Kinds, class Kind>
static inline void append_strips(const ClusterStore& store, const ExtractionTask& task,
                                 unsigned kind, SimdMemory& memory, StripOutput& output) {
    const Batch& batch = memory.batch;
    const ActiveTriangles& active = batch.active[kind];
    if (active.count == 0) return;
    const LineRules& rules = task.kinds[Kinds::kFirst + kind].rules;
    CrossingMemory& m = memory.crossings;
    SegmentMemory& s = memory.segments;
    const unsigned crossings = list_crossings(active, m, s);
    find_shares(values_of<Kind>(batch, kind), m, crossings);
    find_points(batch, Kind::source(task), m, crossings);
    Kind::test(rules, task, batch, m, crossings);
    unsigned count = active.count;
    if (rules.use_slope) {
        count = keep_accepted(m, s, count);
        if (count == 0) return;
        collect_corners(batch, active, values_of<Kind>(batch, kind), m, s, count);
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
