// SPDX-License-Identifier: GPL-3.0-or-later
// Convex crest lines. With e₁ the direction of the largest curvature and t = tr S, they are the
// zeros of ∇t·e₁ at which ∇t falls along e₁; ∇t is the tangential part of Δn (Δn = −‖S‖² n + ∇t),
// so the heat kernel makes them as robust as Laplacian lines. Only where one convex curvature
// rules, k₁ > 2|k₂|, and the surface turns by at least kLeastRidgeAngle.

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "fixed/fixed_kinds.h"
#include "fixed/segment_tracing.h"
#include "fixed/showing.h"
#include "rules/contour_clearance.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr float kDegrees = 57.29577951308232f;
constexpr float kDominance = 2;
constexpr float kLeastRidgeAngle = 5;  // degrees; less is no edge to any eye

/// All ridges of a surface, whatever the view.
struct FoundRidges {
    /// A point's `gradient` is the angle in degrees by which the surface turns across a kernel,
    /// 2 k₁ √h; its opacity and weight are 1.
    LineSet lines;
    /// What tells how far a point is from a contour, by point.
    struct Form {
        Eigen::Vector3f normal;  ///< n, about unit
        Eigen::Vector3f bend;    ///< k₁ e₁, local
    };
    std::vector<Form> forms;
    std::vector<float> sharpest;  ///< the largest angle of a line's points, by line
};

/// The sharpest bend at a vertex.
struct Bend {
    Eigen::Vector3f direction = Eigen::Vector3f::Zero();  ///< e₁, unit, of either sign
    float angle = 0;       ///< 2 k₁ √h in degrees; 0: no candidate
    float derivative = 0;  ///< ∇(tr S)·e₁
    float curvature = 0;   ///< k₁
};

/// The vector of place v of linear forms.
Eigen::Vector3f read_form(const float* forms, unsigned v) {
    const float* form = forms + v / kFormGroup * 4 * kFormGroup + v % kFormGroup;
    return {form[0], form[kFormGroup], form[2 * kFormGroup]};
}

/// `laplacian`: Δn·D²
Bend bend(const VertexRecord& record, const Eigen::Vector3f& laplacian) {
    const float size = std::cbrt(record.slope_scale);  // √h_e
    const Eigen::Matrix3f s =
        Eigen::Map<const Eigen::Matrix<float, 4, 3>>(record.shape_operator[0]).topRows<3>();
    const float frobenius = s.norm();
    if (!(2 * frobenius * size * kDegrees >= kLeastRidgeAngle)) return {};
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
    solver.computeDirect(s);
    const Eigen::Vector3f k = solver.eigenvalues();  // ascending; one of them is the normal's 0
    Bend bend;
    bend.curvature = k[2];
    bend.angle = 2 * k[2] * size * kDegrees;
    if (!(bend.angle >= kLeastRidgeAngle) || !(k[2] > kDominance * -k[0]) ||
        !(k[2] > kDominance * k[1]))
        return {};
    bend.direction = solver.eigenvectors().col(2);
    bend.derivative = bend.direction.dot(laplacian);
    return bend;
}

/// A zero on an edge between two vertices of the mesh.
struct Zero {
    std::uint64_t edge;  ///< the smaller vertex, then the larger one
    Eigen::Vector3f position;
    float angle;
    FoundRidges::Form form;
};

/// A piece of a ridge in a triangle.
struct Piece {
    Zero ends[2];
};

/// Finds the pieces of ridges in one cluster.
class ClusterRidges {
public:
    explicit ClusterRidges(const PlacedCluster& placed) : placed_(placed) {
        for (unsigned v = 0; v < placed.cluster->vertex_count; ++v)
            bends_[v] = bend(placed.records[v], read_form(placed.laplacians, v));
    }

    void find(std::vector<Piece>& pieces) const {
        for (unsigned t = 0; t < placed_.cluster->triangle_count; ++t)
            add(placed_.triangles[t].corners, pieces);
    }

private:
    void add(const std::uint8_t t[3], std::vector<Piece>& pieces) const {
        const Bend* b[3] = {&bends_[t[0]], &bends_[t[1]], &bends_[t[2]]};
        if (b[0]->angle == 0 || b[1]->angle == 0 || b[2]->angle == 0) return;
        const float sign[3] = {1, sign_to(*b[0], *b[1]), sign_to(*b[0], *b[2])};
        // The directions turn around a point inside: no field of directions, so no ridge.
        if (sign[1] * sign[2] * sign_to(*b[1], *b[2]) < 0) return;
        float f[3];
        Eigen::Vector3f e = Eigen::Vector3f::Zero();
        for (int k = 0; k < 3; ++k) {
            f[k] = sign[k] * b[k]->derivative;
            e += sign[k] * b[k]->direction;
        }
        if ((f[0] < 0) == (f[1] < 0) && (f[0] < 0) == (f[2] < 0)) return;
        if (!falls_along(t, f, e)) return;
        Piece piece;
        int found = 0;
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            if ((f[i] < 0) != (f[j] < 0)) piece.ends[found++] = zero(t[i], t[j]);
        }
        pieces.push_back(piece);
    }

    static float sign_to(const Bend& a, const Bend& b) {
        return a.direction.dot(b.direction) < 0 ? -1.f : 1.f;
    }

    Eigen::Vector3f position(unsigned v) const {
        return Eigen::Map<const Eigen::Vector3f>(placed_.records[v].position);
    }
    Eigen::Vector3f normal(unsigned v) const {
        const auto& s = placed_.records[v].shape_operator;
        return {s[0][3], s[1][3], s[2][3]};
    }

    /// Whether the linear interpolant of f falls along e: a maximum of the curvature.
    bool falls_along(const std::uint8_t t[3], const float f[3], const Eigen::Vector3f& e) const {
        const Eigen::Vector3f a = position(t[0]);
        const Eigen::Vector3f u = position(t[1]) - a;
        const Eigen::Vector3f v = position(t[2]) - a;
        const Eigen::Vector3f area = u.cross(v);
        const Eigen::Vector3f df = (f[1] - f[0]) * v.cross(area) + (f[2] - f[0]) * area.cross(u);
        return df.dot(e) < 0;
    }

    /// The same from the triangles on both sides.
    Zero zero(unsigned a, unsigned b) const {
        if (placed_.vertices[b] < placed_.vertices[a]) std::swap(a, b);
        const float fa = std::abs(bends_[a].derivative), sum = fa + std::abs(bends_[b].derivative);
        const float t = sum > 0 ? fa / sum : 0.5f;
        const Eigen::Vector3f bend_a = bends_[a].curvature * bends_[a].direction;
        const Eigen::Vector3f bend_b = bends_[b].curvature * bends_[b].direction;
        return {std::uint64_t(placed_.vertices[a]) << 32 | placed_.vertices[b],
                (1 - t) * position(a) + t * position(b),
                (1 - t) * bends_[a].angle + t * bends_[b].angle,
                {(1 - t) * normal(a) + t * normal(b),
                 (1 - t) * bend_a + t * sign_to(bends_[a], bends_[b]) * bend_b}};
    }

    const PlacedCluster& placed_;
    Bend bends_[kClusterVertices];
};

/// In the order of the clusters.
std::vector<std::vector<Piece>> find_pieces(const ExtractorData& data) {
    const std::vector<PlacedCluster> placed = place_clusters(data);
    std::vector<std::vector<Piece>> pieces(placed.size());
    in_parallel<NoScratch>(placed.size(), [&](std::size_t c, NoScratch&) {
        ClusterRidges(placed[c]).find(pieces[c]);
    });
    return pieces;
}

/// Joins the pieces at their ends.
class RidgeGraph {
public:
    explicit RidgeGraph(const std::vector<std::vector<Piece>>& pieces) {
        for (const std::vector<Piece>& of_cluster : pieces)
            for (const Piece& piece : of_cluster) {
                const std::uint32_t begin = crossing(piece.ends[0]);
                graph_.segments.push_back({begin, crossing(piece.ends[1]), 0});
            }
    }
    const CrossingGraph& graph() const { return graph_; }
    /// The zero that a traced point comes from. Above 2^24 crossings, one beside it.
    const Zero& zero(const LinePoint& point) const {
        return *zeros_[std::min(std::size_t(point.gradient), zeros_.size() - 1)];
    }

private:
    std::uint32_t crossing(const Zero& zero) {
        const auto number = std::uint32_t(zeros_.size());
        const auto [place, is_new] = crossing_of_edge_.try_emplace(zero.edge, number);
        if (is_new) {
            // Its number travels through the tracing in place of a gradient.
            graph_.crossings.push_back({zero.position, float(number), 1});
            zeros_.push_back(&zero);
        }
        return place->second;
    }

    CrossingGraph graph_;
    std::vector<const Zero*> zeros_;  // by crossing
    std::unordered_map<std::uint64_t, std::uint32_t> crossing_of_edge_;
};

/// The number of threads does not matter.
FoundRidges find_ridges(const ExtractorData& data) {
    const std::vector<std::vector<Piece>> pieces = find_pieces(data);
    const RidgeGraph graph(pieces);
    LineRules rules;
    rules.kind = LineKind::Ridge;
    TracingMemory memory;
    FoundRidges ridges;
    trace_segments(data, rules, graph.graph(), memory, ridges.lines);
    for (LinePoint& point : ridges.lines.points) {
        const Zero& zero = graph.zero(point);
        ridges.forms.push_back(zero.form);
        point.gradient = zero.angle;
    }
    for (Polyline& line : ridges.lines.lines) {
        line.strength = 0;
        float most = 0;
        for (std::uint32_t i = 0; i < line.count; ++i)
            most = std::max(most, ridges.lines.points[line.first + i].gradient);
        ridges.sharpest.push_back(most);
    }
    return ridges;
}

class Ridges : public FixedKindLines {
public:
    explicit Ridges(const ExtractorData& data) : found_(find_ridges(data)) {}

    void append(const ExtractorData& data, const LocalEye& eye, const LineStyle& style,
                LineSet& lines) const override {
        // Angles differ less than slopes do: the eighth root, and part of the fading.
        const float angle =
            float(std::pow(threshold_factor(style.detail), 0.125) * style.ridge_angle);
        const float fading = 0.4f * float(style.fading);
        // The contour of a rounded edge stays near its crest for long.
        const float clearance =
            style.shows[LineKind::Contour] ? 4 * float(style.contour_clearance) : 0;
        const auto opacity_of = [&](std::size_t i) {
            const LinePoint& point = found_.lines.points[i];
            const float opacity = angle_opacity(point.gradient, angle, fading);
            if (opacity == 0) return opacity;
            const Eigen::Vector3f l = eye.towards(
                ((point.position.cast<double>() - data.centre) / data.diagonal).cast<float>());
            const FoundRidges::Form& form = found_.forms[i];
            const float facing = std::abs(form.normal.dot(l));
            const float gradient = std::abs(form.bend.dot(l));
            return opacity * clearance_opacity(facing, std::max(gradient, 1e-6f), clearance);
        };
        append_lines(
            found_.lines, {shortest_line(style), smoothing_passes(style.line_smoothing)},
            [&](std::size_t line) { return found_.sharpest[line] >= angle; }, opacity_of, lines);
    }

private:
    const FoundRidges found_;
};

}  // namespace

const FixedKind ridges = fixed_kind<Ridges>(LineKind::Ridge);

}  // namespace laplacian_lines
