// SPDX-License-Identifier: GPL-3.0-or-later
// Segments of lines in single triangles and their tests.
// Included once by each of the files cluster_kernels_*.cpp.
#pragma once

#include "kernel_crossings.h"

namespace laplacian_lines {
namespace KERNEL_NAMESPACE {

/// Lists the crossings of a cluster's active triangles. A triangle owns the crossing where its line
/// leaves, which gets the triangle's place; the one where the line enters is that of the triangle
/// before, or one of its own if that one is elsewhere. Returns the number of crossings.
static inline unsigned list_crossings(const ActiveTriangle* active, unsigned count,
                                      CrossingMemory& m, SegmentMemory& s) {
    // Places in `active` by the triangles' numbers; all others are kNoNeighbour.
    std::uint8_t* place = s.segment_of_triangle;
    __builtin_memset(place, kNoNeighbour, sizeof(s.segment_of_triangle));
    for (unsigned i = 0; i < count; ++i) {
        place[active[i].number] = std::uint8_t(i);
        m.ends[i][0] = active[i].exit[0];
        m.ends[i][1] = active[i].exit[1];
    }
    unsigned crossings = count;
    for (unsigned i = 0; i < count; ++i) {  // without branches, which would be guessed wrong
        const unsigned previous = place[active[i].previous];
        const bool own = previous == kNoNeighbour;
        m.ends[crossings][0] = active[i].entry[0];
        m.ends[crossings][1] = active[i].entry[1];
        s.triangle[i] = std::uint8_t(i);
        s.begin[i] = std::uint16_t(own ? crossings : previous);
        crossings += own;
    }
    return crossings;
}

/// Leaves out segments with a refused crossing; returns how many are left.
static inline unsigned keep_accepted(const CrossingMemory& m, SegmentMemory& s, unsigned count) {
    unsigned kept = 0;
    for (unsigned i = 0; i < count; ++i) {
        s.triangle[kept] = std::uint8_t(i);
        s.begin[kept] = s.begin[i];
        kept += (m.opacity[i] >= 0) & (m.opacity[s.begin[i]] >= 0);
    }
    for (unsigned i = kept; i < kept + kLanes; ++i)  // something valid
        s.triangle[i] = s.begin[i] = 0;
    return kept;
}

/// Lengths and strengths (Eq. 4) of segments [0, count).
static inline void measure_segments(const CrossingMemory& m, SegmentMemory& s, std::size_t count) {
    count = whole_vectors(count);
    for (std::size_t i = 0; i < count; ++i) {
        const unsigned a = s.begin[i], b = s.triangle[i];
        s.dx[i] = m.x[b] - m.x[a];
        s.dy[i] = m.y[b] - m.y[a];
        s.dz[i] = m.z[b] - m.z[a];
        s.gradient[i] = m.gradient[a] + m.gradient[b];
    }
    for (std::size_t i = 0; i < count; ++i) {
        s.length[i] = __builtin_sqrtf(s.dx[i] * s.dx[i] + s.dy[i] * s.dy[i] + s.dz[i] * s.dz[i]);
        s.strength[i] = s.gradient[i] / 2 * s.length[i];
    }
}

/// Collects what test_segments() needs as columns.
static inline void collect_corners(const VertexRecord* records, const SignedCluster& signs,
                                   const CrossingMemory& m, SegmentMemory& s, unsigned count) {
    const float* values = signs.values[kLaplacianStrips];
    for (unsigned i = 0; i < count; i += 4) {
        Float4 u[4], v[4], g[4];
        for (unsigned k = 0; k < 4; ++k) {
            const ActiveTriangle& t = signs.active[kLaplacianStrips][s.triangle[i + k]];
            const Float4 a = load4(records[t.exit[0]].position),
                         b = load4(records[t.exit[1]].position),
                         c = load4(records[t.third].position);
            u[k] = b - a;
            v[k] = c - a;
            const Float4 gradients =
                load4(m.gradients[s.begin[i + k]]) + load4(m.gradients[s.triangle[i + k]]);
            const Float4 scales = a + b + c;
            g[k] = __builtin_shuffle(gradients, scales, Int4{0, 1, 2, 7});
            s.fu[i + k] = values[t.exit[1]] - values[t.exit[0]];
            s.fv[i + k] = values[t.third] - values[t.exit[0]];
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

/// Slope of the function across the line, and whether the illumination's gradient is largest
/// there (edge) or smallest (phantom). Refused segments get the slope −1.
static inline void test_segments(const LineRules& rules, SegmentMemory& s, std::size_t count) {
    const float largest_product = rules.reject_phantoms ? 0 : FLT_MAX;
    count = whole_vectors(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float ux = s.ux[i], uy = s.uy[i], uz = s.uz[i];
        const float vx = s.vx[i], vy = s.vy[i], vz = s.vz[i];
        const float nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
        // ∇f of the linear interpolant: (fu·(v × N) + fv·(N × u)) / |N|², N = u × v.
        const float fu = s.fu[i], fv = s.fv[i], squared = nx * nx + ny * ny + nz * nz;
        const float x = fu * (vy * nz - vz * ny) + fv * (ny * uz - nz * uy);
        const float y = fu * (vz * nx - vx * nz) + fv * (nz * ux - nx * uz);
        const float z = fu * (vx * ny - vy * nx) + fv * (nx * uy - ny * ux);
        const float steepness = __builtin_sqrtf(x * x + y * y + z * z) / squared;
        const float slope = steepness * (s.scale[i] / 3);
        const float product = x * s.gx[i] + y * s.gy[i] + z * s.gz[i];
        const float kept = product <= largest_product ? slope : -1.f;
        s.slope[i] = slope >= rules.segment_slope ? kept : -1.f;  // also for a sliver's NaN
    }
}

/// Leaves out refused segments; returns how many are left.
static inline unsigned keep_steep(SegmentMemory& s, unsigned count) {
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

}  // namespace KERNEL_NAMESPACE
}  // namespace laplacian_lines
