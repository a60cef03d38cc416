// SPDX-License-Identifier: GPL-3.0-or-later
// Apparent ridges: where the view-dependent curvature q1 is largest along the direction r that
// belongs to it (T. Judd, F. Durand, E. Adelson, "Apparent Ridges for Line Drawing", 2007). r has
// no sign and neither has the derivative D of q1 along it, so that zeros of D are found by D r at
// both ends of an edge, and lines get their direction triangle by triangle.
#pragma once

#include "redraw/simd/simd_batch.h"
#include "redraw/simd/simd_strips.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// q1, D and r at vertices; q1 = 0 where they face away or have no direction.
struct ApparentCurvature {
    Floats q, derivative;
    Vectors direction;
};

/// The vector to the eye of unit length, by its cosine with the normal and its tangential part w;
/// and how vectors on the screen lie in the tangent plane, A = P⁻¹ = 1 + k w wᵀ: longer by 1/cosine
/// along w.
struct Sight {
    Floats per_distance, cosine, k;
    Tangents w;

    Sight(const CurvatureColumns& p, const float eye[4]) {
        const Vectors e = {Floats{} + eye[0], Floats{} + eye[1], Floats{} + eye[2]};
        const Vectors v = e - p.position * (Floats{} + eye[3]);
        const Floats distance = square_root(dot(v, v));
        per_distance = eye[3] / distance;
        const Vectors unit = v * (1 / distance);
        cosine = dot(p.normal, unit);
        w = p.tangent(unit);
        k = 1 / (cosine * (1 + cosine));
    }

    Tangents to_surface(const Tangents& screen) const { return screen + w * (k * dot(w, screen)); }
    Tangents u_to_surface() const { return {1 + k * w.u * w.u, k * w.u * w.v}; }
    Tangents v_to_surface() const { return {k * w.u * w.v, 1 + k * w.v * w.v}; }

    /// x·(dA t) for tangents x and t, dA the change of A along r.
    Floats change(const CurvatureColumns& p, const Tangents& r, const Tangents& x,
                  const Tangents& t) const {
        const Tangents sr = p.S(r);
        const Floats wr = dot(w, r);
        const Floats d_cosine = dot(sr, w) + per_distance * cosine * wr;
        const Tangents dw = (r - w * wr) * (-per_distance) - sr * cosine;
        const Floats wx = dot(w, x), wt = dot(w, t);
        return k * (dot(dw, x) * wt + wx * dot(dw, t)) -
               k * k * (1 + 2 * cosine) * d_cosine * wx * wt;
    }
};

/// q1² is the larger eigenvalue of (S A)ᵀ S A, t its direction, r that of A t; the derivative of an
/// eigenvalue is that of the matrix between its directions: 2 q1 D = 2 (S b·dA t + C(r, a, b)) with
/// a = A t, b = S a.
static inline ApparentCurvature apparent_curvature(const CurvatureColumns& p, const Sight& sight) {
    const Tangents su = p.S(sight.u_to_surface()), sv = p.S(sight.v_to_surface());
    const Floats uu = dot(su, su), uv = dot(su, sv), vv = dot(sv, sv);
    const Floats half = (uu - vv) / 2, root = square_root(half * half + uv * uv);
    const Floats squared = (uu + vv) / 2 + root, q = square_root(squared);
    const Ints along_u = half > 0;
    const Floats larger = absolute(half) + root;
    const Floats tu = along_u ? larger : uv, tv = along_u ? uv : larger;
    const Floats length = square_root(tu * tu + tv * tv);
    const Tangents t = {tu / length, tv / length};
    const Tangents a = sight.to_surface(t), b = p.S(a);
    const Tangents r = a * (1 / square_root(dot(a, a)));
    const Floats derivative = (sight.change(p, r, p.S(b), t) + p.C(r, a, b)) / q;
    const Ints usable = (sight.cosine > 0) & (length > 0);
    return {usable ? q : Floats{}, derivative, p.in_space(r)};
}

static inline void evaluate_apparent(const ClusterInSlot& place, const float eye[4],
                                     ApparentMemory& m) {
    const unsigned first = place.slot * kClusterVertices, count = place.cluster.vertex_count;
    for (unsigned i = 0; i < form_groups(place.cluster) * kFormGroup; i += kLanes) {
        const CurvatureColumns p(curvatures_of(place), i, count);
        const Sight sight(p, eye);
        if (bits_of(sight.cosine > 0) == 0) {
            store(m.q + first + i, Floats{});
            continue;
        }
        const ApparentCurvature c = apparent_curvature(p, sight);
        store(m.q + first + i, c.q);
        Floats columns[4] = {c.direction.x, c.direction.y, c.direction.z, c.derivative};
        store_as_rows(columns, [&](unsigned lane) { return m.vectors[first + i + lane]; });
    }
}

/// Cosine, of 46°: directions at the ends of an edge that differ by more belong to no common line.
constexpr float kLeastAgreement = 0.7f;

/// For kLanes triangles, from r and D at their corners: a bit for each side on which D r changes
/// its direction, lowest first; none where directions turn.
static inline Ints crossed_sides(const Floats (*corners)[4]) {
    Ints sides = {}, agree = Ints{} - 1;
    for (unsigned k = 0; k < 3; ++k) {
        const Floats *a = corners[k], *b = corners[(k + 1) % 3];
        const Floats cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        agree &= cosine * cosine >= kLeastAgreement * kLeastAgreement;
        sides |= ((a[3] < 0) ^ (b[3] < 0) ^ (cosine < 0)) & (1 << k);
    }
    return sides & agree;
}

static inline float dot3(const float* a, const float* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The side that a line does not cross, by crossed_sides(); kNoLine unless it crosses two.
constexpr std::uint8_t kNoLine = 3;
constexpr std::uint8_t kUncrossed[8] = {kNoLine, kNoLine, kNoLine, 2, kNoLine, 1, 0, kNoLine};

/// Of crossings. Means along whole lines are asked for the rest.
static inline float least_curvature(const LineRules& rules) {
    return rules.whole ? rules.least_gradient / (1 + rules.fading) : rules.least_gradient;
}

/// Lists the triangles of a cluster that lines pass. Which of its two crossings a line leaves by is
/// chosen so that neighbours agree.
class ApparentTriangles {
public:
    ApparentTriangles(const LineRules& rules, const ClusterInSlot& place,
                      const ApparentMemory& memory)
        : cluster_(place.cluster), slot_(place.slot), triangles_(triangles_of(place)) {
        __builtin_memset(uncrossed_, kNoLine, sizeof uncrossed_);
        find_wanted(rules, place, memory);
        find_crossed(memory);
    }

    void append(ActiveTriangles& active) {
        for (unsigned place = 0; place < count_; ++place) {
            const unsigned i = listed_[place];
            if (uncrossed_[i] == kNoLine) continue;
            unsigned first = i, entry = (uncrossed_[i] + 1) % 3;
            for (;;) {  // back to where the line begins, or once round
                const unsigned before = across(first, entry);
                if (before == kNoNeighbour || before == i) break;
                entry = other_side(before, side_behind(first, entry, before));
                first = before;
            }
            follow(first, entry, active);
        }
    }

private:
    /// Lists the triangles that face the eye, with a strong curvature at a corner.
    void find_wanted(const LineRules& rules, const ClusterInSlot& place,
                     const ApparentMemory& memory) {
        const float* q = memory.q + slot_ * kClusterVertices;
        const BelowBound weak = below(q, form_groups(cluster_), least_curvature(rules));
        if (weak.all) return;
        VertexSigns signs;
        signs.set(kWeak, weak.bits);
        signs.set(kUnseen, below(q, form_groups(cluster_), FLT_MIN).bits);
        const unsigned char* corners = place.memory + place.layout.corners;
        for (unsigned g = 0; g < mask_groups(cluster_); ++g, corners += 3 * kMaskGroup) {
            const CornerLookup a(corners, signs), b(corners + kMaskGroup, signs),
                c(corners + 2 * kMaskGroup, signs);
            std::uint64_t unwanted = (a(kWeak) & b(kWeak) & c(kWeak)) |  //
                                     a(kUnseen) | b(kUnseen) | c(kUnseen);
            if (rules.drop_featureless) unwanted |= cluster_.featureless[g];
            for (std::uint64_t wanted = ~unwanted & existing(g); wanted; wanted &= wanted - 1)
                listed_[count_++] =
                    std::uint8_t(g * kMaskGroup + unsigned(__builtin_ctzll(wanted)));
        }
    }
    /// A bit for each triangle that a group has.
    std::uint64_t existing(unsigned group) const {
        const unsigned rest = cluster_.triangle_count - group * kMaskGroup;
        return rest < kMaskGroup ? (std::uint64_t(1) << rest) - 1 : ~std::uint64_t(0);
    }

    /// Keeps the listed triangles that lines pass, and notes which sides they do not cross.
    void find_crossed(const ApparentMemory& memory) {
        const float(*vectors)[4] = memory.vectors + slot_ * kClusterVertices;
        for (unsigned i = count_; i < count_ + kLanes; ++i)  // something valid
            listed_[i] = 0;
        unsigned kept = 0;
        for (unsigned first = 0; first < count_; first += kLanes) {
            Floats corners[3][4];
            for (unsigned k = 0; k < 3; ++k)
                load_columns(
                    [&](unsigned lane) {
                        return vectors[triangle_at(triangles_, listed_[first + lane]).corners[k]];
                    },
                    corners[k]);
            const Ints sides = crossed_sides(corners);
            const unsigned lanes = count_ - first < kLanes ? count_ - first : kLanes;
            for (unsigned lane = 0; lane < lanes; ++lane) {
                const unsigned triangle = listed_[first + lane];
                uncrossed_[triangle] = kUncrossed[sides[lane]];
                listed_[kept] = std::uint8_t(triangle);
                kept += uncrossed_[triangle] != kNoLine;
            }
        }
        count_ = kept;
    }

    /// Lists what a line passes that enters a triangle by a side, and takes it from the list.
    void follow(unsigned triangle, unsigned entry, ActiveTriangles& active) {
        for (;;) {
            const unsigned exit = other_side(triangle, entry);
            write(triangle, entry, exit, active);
            uncrossed_[triangle] = kNoLine;
            const unsigned next = across(triangle, exit);
            if (next == kNoNeighbour) return;
            entry = side_behind(triangle, exit, next);
            triangle = next;
        }
    }

    void write(unsigned number, unsigned entry, unsigned exit, ActiveTriangles& active) const {
        const ClusterTriangle t = triangle_at(triangles_, number);
        const auto corner = [&](unsigned k) {
            return std::uint16_t(slot_ * kClusterVertices + t.corners[k % 3]);
        };
        const auto triangle_place = [&](unsigned n) {
            return std::uint16_t(slot_ * kNumbersOfSlot + n);
        };
        const unsigned place = active.count++;
        active.triangles[place] = {{corner(exit), corner(exit + 1)},
                                   corner(exit + 2),
                                   triangle_place(number),
                                   {corner(entry), corner(entry + 1)},
                                   triangle_place(t.neighbours[exit]),
                                   triangle_place(t.neighbours[entry])};
    }

    /// The listed triangle of this cluster behind a side, or kNoNeighbour.
    unsigned across(unsigned triangle, unsigned side) const {
        const unsigned next = triangle_at(triangles_, triangle).neighbours[side];
        return next < cluster_.triangle_count && uncrossed_[next] != kNoLine ? next : kNoNeighbour;
    }
    /// The neighbour's name of the side that it shares.
    unsigned side_behind(unsigned triangle, unsigned side, unsigned neighbour) const {
        const std::uint8_t end = triangle_at(triangles_, triangle).corners[(side + 1) % 3];
        const auto& corners = triangle_at(triangles_, neighbour).corners;
        return corners[0] == end ? 0 : corners[1] == end ? 1 : 2;
    }
    unsigned other_side(unsigned triangle, unsigned side) const {
        return 3 - side - uncrossed_[triangle];
    }

    const Cluster& cluster_;
    const unsigned slot_;
    const ClusterTriangles triangles_;
    unsigned count_ = 0;
    std::uint8_t listed_[kClusterTriangles + kLanes];
    std::uint8_t uncrossed_[kClusterTriangles];
    static constexpr unsigned kWeak = 0, kUnseen = 1;  // sets of signs
};

/// Where crossings are, which are accepted, their opacities, and q1 there as the gradient.
static inline void find_apparent_crossings(const LineRules& rules, const ExtractionTask& task,
                                           const Batch& batch, ApparentMemory& apparent,
                                           CrossingMemory& m, std::size_t count) {
    const std::size_t places = whole_vectors(count);
    for (std::size_t i = 0; i < places; ++i) {
        const unsigned a = m.ends[i][0], b = m.ends[i][1];
        const float below = __builtin_fabsf(apparent.vectors[a][3]) + FLT_MIN,
                    sum = below + __builtin_fabsf(apparent.vectors[b][3]);
        const float share = sum <= FLT_MAX ? below / sum : 0.5f;
        m.share[i] = share;
        apparent.crossing_q[i] = (1 - share) * apparent.q[a] + share * apparent.q[b];
    }
    find_points(batch, task.eye, m, count);
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Vectors v = towards(task.eye, m, i);
        const Floats q = load(apparent.crossing_q + i), facing = load(m.lit + i);
        accept(
            (q >= least_curvature(rules)) & (facing >= rules.least_facing * square_root(dot(v, v))),
            m, i);
        store(m.opacity + i, opacity_beside_contours(rules, facing, load(m.gradient + i)));
        store(m.gradient + i, q);
    }
    for (std::size_t i = 0; i < places; ++i)
        m.points[i][3] = apparent.crossing_q[i];
}

/// Collects what test_segments() needs: D with the sign that goes with r at the first corner.
static inline void collect_apparent_corners(const Batch& batch, const ActiveTriangles& active,
                                            const ApparentMemory& apparent, SegmentMemory& s,
                                            unsigned count) {
    for (std::size_t i = 0; i < whole_vectors(count); ++i) {
        const ActiveTriangle& t = active.triangles[s.triangle[i]];
        const unsigned corners[3] = {t.exit[0], t.exit[1], t.third};
        Float4 direction = {}, p[3];
        float values[3];
        for (unsigned k = 0; k < 3; ++k) {
            p[k] = load4(position_at(records_around(batch, corners[k]), corners[k]));
            const float* vector = apparent.vectors[corners[k]];
            const float sign = dot3(apparent.vectors[corners[0]], vector) < 0 ? -1.f : 1.f;
            values[k] = sign * vector[3];
            direction += sign * load4(vector);
        }
        const Float4 u = p[1] - p[0], v = p[2] - p[0];
        s.fu[i] = values[1] - values[0];
        s.fv[i] = values[2] - values[0];
        const Float4 squares = direction * direction;
        const float unit = 2 / __builtin_sqrtf(squares[0] + squares[1] + squares[2]);  // two ends
        for (int k = 0; k < 3; ++k) {
            s.u[k][i] = u[k];
            s.v[k][i] = v[k];
            s.g[k][i] = unit * direction[k];
        }
    }
}

/// The part of a kind (simd_kinds.h) that cull() and begin_batch() ask for.
struct ApparentRidges : OnFacingSurface {
    static constexpr LineKind kKind = LineKind::ApparentRidge;
    static constexpr unsigned kForms = kCurvatures;
};

using ApparentKinds = KindList<3, ApparentRidges>;
static_assert(ApparentKinds::is_as_declared(), "the same kind");

static void extract_apparent_strips(const ClusterStore& store, const ExtractionTask& task,
                                    const KeptCluster* clusters, std::size_t count,
                                    SimdMemory& memory, StripOutput* outputs) {
    using Kinds = ApparentKinds;
    const LineRules& rules = task.kinds[Kinds::kFirst].rules;
    Batch& batch = memory.batch;
    begin_batch<Kinds>(store, clusters, count, batch);
    ActiveTriangles& active = batch.active[0];
    active.count = 0;
    for (unsigned slot = 0; slot < batch.count; ++slot) {
        const ClusterInSlot place = place_of(store, batch, slot);
        evaluate_apparent(place, task.eye, memory.apparent);
        ApparentTriangles(rules, place, memory.apparent).append(active);
    }
    if (active.count == 0) return;
    CrossingMemory& m = memory.crossings;
    SegmentMemory& s = memory.segments;
    const unsigned crossings = list_crossings(active, m, s);
    find_apparent_crossings(rules, task, batch, memory.apparent, m, crossings);
    unsigned kept = keep_accepted(m, s, active.count);
    collect_apparent_corners(batch, active, memory.apparent, s, kept);
    test_segments<SegmentSlope::AlongOnce>(rules, s, kept);
    kept = keep_steep(rules, s, kept);
    measure_segments(rules, m, s, kept);
    StripWriter(store, batch, active, m, s, kept, *outputs).write_all(rules);
}

}  // namespace SIMD_SET
}  // namespace laplacian_lines
