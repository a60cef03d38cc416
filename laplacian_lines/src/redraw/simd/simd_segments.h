// SPDX-License-Identifier: GPL-3.0-or-later
// Segments of lines in single triangles and their tests.
#pragma once

#include "redraw/simd/simd_crossings.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// Lists the crossings of a batch's active triangles. A triangle owns the crossing where its line
/// leaves, which gets the triangle's place; the one where the line enters is that of the triangle
/// before, or one of its own if that one is elsewhere. Returns the number of crossings.
static inline unsigned list_crossings(const ActiveTriangles& active, CrossingMemory& m,
                                      SegmentMemory& s) {
    const auto list = [&](unsigned crossing, const std::uint16_t ends[2]) {
        __builtin_memcpy(m.ends[crossing], ends, sizeof m.ends[0]);
    };
    for (unsigned i = 0; i < active.count; ++i)  // all that is asked for
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
    return crossings;
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
    for (unsigned i = kept; i < kept + kLanes; ++i)  // something valid
        s.triangle[i] = s.begin[i] = 0;
    return kept;
}

/// Keeps all segments; the counterpart of keep_accepted().
static inline unsigned keep_all(SegmentMemory& s, unsigned count) {
    for (unsigned i = 0; i < count; ++i)
        s.triangle[i] = std::uint16_t(i);
    for (unsigned i = count; i < count + kLanes; ++i)  // something valid
        s.triangle[i] = s.begin[i] = 0;
    return count;
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
        Float4 u[4], v[4], g[4];
        for (unsigned k = 0; k < 4; ++k) {
            const unsigned place = s.triangle[i + k];
            const ActiveTriangle& t = active.triangles[place];
            const RecordsOfSlot records = records_around(batch, t.third);
            const Float4 a = load4(records[t.exit[0]]), b = load4(records[t.exit[1]]),
                         c = load4(records[t.third]);
            u[k] = b - a;
            v[k] = c - a;
            const Float4 gradients = load4(m.gradients[s.begin[i + k]]) + load4(m.gradients[place]);
            const Float4 scales = a + b + c;
            g[k] = shuffle<0, 1, 2, 7>(gradients, scales);
            s.fu[i + k] = m.above[place] - m.below[place];
            s.fv[i + k] = function[t.third] - m.below[place];
        }
        transpose(u);
        transpose(v);
        transpose(g);
        store_columns(u, s.ux + i, s.uy + i, s.uz + i);
        store_columns(v, s.vx + i, s.vy + i, s.vz + i);
        store_columns(g, s.gx + i, s.gy + i, s.gz + i);
        __builtin_memcpy(s.scale + i, &g[3], sizeof(Float4));
    }
}

/// What the slope of a segment is, of whole lines less than 0 where ∇f·d > 0: with ∇f of the linear
/// interpolant and the vectors d that a kind's test leaves in CrossingMemory::gradients,
enum class SegmentSlope {
    Scaled,     ///< ‖∇f‖ times slope_scale
    Along,      ///< −∇f·d, a change in a squared length, times h_e, to the power 1.5
    AlongOnce,  ///< −∇f·d, a change in a length to the power 3, times h_e^1.5
};

/// Slope of the function across the line, and whether the illumination's gradient is largest
/// there (edge) or smallest (phantom). Refused segments get the slope −1.
template <SegmentSlope Slope>
static inline void test_segments(const LineRules& rules, SegmentMemory& s, std::size_t count) {
    const float largest_product = rules.reject_phantoms ? 0 : FLT_MAX;
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Floats ux = load(s.ux + i), uy = load(s.uy + i), uz = load(s.uz + i);
        const Floats vx = load(s.vx + i), vy = load(s.vy + i), vz = load(s.vz + i);
        const Floats nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
        // ∇f of the linear interpolant: (fu·(v × N) + fv·(N × u)) / |N|², N = u × v.
        const Floats fu = load(s.fu + i), fv = load(s.fv + i);
        const Floats squared = nx * nx + ny * ny + nz * nz;
        const Floats x = fu * (vy * nz - vz * ny) + fv * (ny * uz - nz * uy);
        const Floats y = fu * (vz * nx - vx * nz) + fv * (nz * ux - nx * uz);
        const Floats z = fu * (vx * ny - vy * nx) + fv * (nx * uy - ny * ux);
        const Floats product = x * load(s.gx + i) + y * load(s.gy + i) + z * load(s.gz + i);
        if (Slope != SegmentSlope::Scaled) {
            const Floats change = -product / (2 * squared);  // d summed over both ends
            const Floats size = absolute(change);
            const Floats powered = Slope == SegmentSlope::Along ? size * square_root(size) : size;
            const Floats slope = powered * (load(s.scale + i) / 3);
            const Floats most = at_most(slope, rules.segment_slope + rules.full_slope);
            const Ints kept = (slope >= rules.segment_slope) & (change > 0);
            if (rules.whole)  // nothing of a sliver's NaN
                store(s.slope + i, change > 0 ? most : (change <= 0 ? -most : Floats{}));
            else
                store(s.slope + i, kept ? most : Floats{} - 1);
            continue;
        }
        const Floats steepness = square_root(x * x + y * y + z * z) / squared;
        const Floats slope = steepness * (load(s.scale + i) / 3);
        if (rules.whole) {  // nothing of a sliver's NaN
            store(s.slope + i, slope >= 0 ? (product <= 0 ? slope : -slope) : Floats{});
            continue;
        }
        // Not so for a sliver's NaN, too.
        const Ints kept = (slope >= rules.segment_slope) & (product <= largest_product);
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
    for (unsigned i = kept; i < kept + kLanes; ++i)  // something valid
        s.triangle[i] = s.begin[i] = 0;
    return kept;
}

}  // namespace SIMD_SET
}  // namespace laplacian_lines
