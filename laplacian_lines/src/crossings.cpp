// SPDX-License-Identifier: GPL-3.0-or-later
// Zero crossings on edges and their tests: L. Zhang, Y. He, H. S. Seah, "Laplacian Lines for
// Real-Time Shape Illustration", steps 1 and 2 of the extraction.
#include "crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contour_clearance.h"

namespace laplacian_lines {

double threshold_factor(double detail) {
    // Fitted to the number of lines on the Stanford bunny and dragon, igea and the armadillo.
    const double x = detail / 50 - 1;  // -1..1
    return std::exp2(x < 0 ? 3.5 * std::pow(-x, 1.6) : -5 * std::pow(x, 1.3));
}

int smoothing_passes(double deviation) {
    return int(std::lround(2 * deviation * deviation));  // a pass has a variance of 1/2
}

LineRules laplacian_rules(const LineStyle& s) {
    const double factor = threshold_factor(s.detail);
    LineRules rules;
    rules.kind = LineKind::Laplacian;
    rules.least_gradient = float(factor * s.gradient_threshold);
    rules.least_facing = float(s.least_facing);
    rules.reject_phantoms = s.reject_phantoms;
    rules.concave_only = s.single_strokes;
    rules.use_slope = true;
    rules.segment_slope = float(factor * s.segment_slope);
    rules.line_slope = float(factor * s.line_slope);
    rules.full_slope = float(s.full_slope);
    rules.least_strength = float(factor * s.strength_threshold);
    rules.least_length = float(std::sqrt(factor) * s.shortest_line);
    rules.fading = float(s.fading);
    rules.smoothing_passes = smoothing_passes(s.line_smoothing);
    rules.end_length = float(s.end_length);
    rules.contour_clearance = s.contours ? float(s.contour_clearance) : 0;
    return rules;
}

LineRules contour_rules(const LineStyle& s) {
    LineRules rules;
    rules.kind = LineKind::Contour;
    rules.least_length = float(s.shortest_contour);
    rules.smoothing_passes = smoothing_passes(s.line_smoothing);
    return rules;
}

namespace {

void evaluate(const LinearForms& forms, const LocalEye& eye, LineFunction function,
              std::vector<VertexValue>& values) {
    const float ex = eye.eye.x(), ey = eye.eye.y(), ez = eye.eye.z(), w = eye.w;
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i].*function =
            forms.x[i] * ex + forms.y[i] * ey + forms.z[i] * ez - w * forms.offset[i];
}

}  // namespace

void evaluate_vertices(const ExtractorData& data, const LocalView& view, const LineStyle& style,
                       VertexValues& vertices) {
    std::vector<VertexValue>& values = vertices.values;
    values.resize(data.vertices.size());
    evaluate(data.normals, view.eye, &VertexValue::facing, values);
    evaluate(data.laplacians, view.light, &VertexValue::laplacian, values);
    if (style.exact_point_light)  // the cross term that the paper's derivation loses
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i].laplacian -= view.light.w * data.vertices[i].shape_operator.trace();
    // Local points are within 1/2 of the centre, so |l| is within w/2 of |e|; a bound that
    // needs no |l| and never refuses too much.
    const float least_facing = float(style.least_facing);
    const LocalEye& eye = view.eye;
    const float length = eye.eye.norm() + (least_facing < 0 ? eye.w : -eye.w) / 2;
    const float least_scaled_facing = least_facing * std::max(length, 0.f);
    vertices.signs.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        vertices.signs[i] = std::uint8_t((values[i].laplacian < 0 ? kNegativeLaplacian : 0) |
                                         (values[i].facing < 0 ? kNegativeFacing : 0) |
                                         (values[i].facing < least_scaled_facing ? kFacesAway : 0));
}

void find_mixed_triangles(const ExtractorData& data, const VertexValues& values,
                          MixedTriangles& mixed) {
    mixed.laplacian.clear();
    mixed.contour.clear();
    const std::uint8_t* signs = values.signs.data();
    for (std::uint32_t i = 0; i < data.triangles.size(); ++i) {
        const Triangle& t = data.triangles[i];
        const unsigned a = signs[t[0]], b = signs[t[1]], c = signs[t[2]];
        const unsigned differing = (a ^ b) | (a ^ c);
        if (!(differing & (kNegativeLaplacian | kNegativeFacing))) continue;
        if ((differing & kNegativeLaplacian) && !(a & b & c & kFacesAway))
            mixed.laplacian.push_back({i, t});
        if (differing & kNegativeFacing) mixed.contour.push_back({i, t});
    }
}

namespace {

constexpr std::size_t kPrefetchDistance = 12;  // triangles; half a microsecond of work

class SegmentFinder {
public:
    SegmentFinder(const ExtractorData& data, const LocalView& view, const LineRules& rules,
                  const VertexValues& values, LineFunction function, CrossingGraph& graph)
        : data_(data),
          view_(view),
          rules_(rules),
          values_(values.values),
          function_(function),
          graph_(graph) {}

    // Lines are far apart in memory, so what add() reads is asked for in two steps. Inlined always:
    // GCC takes functions that only prefetch for ones without effect and drops calls of them.
    [[gnu::always_inline]] void prefetch_edges(const MixedTriangle& triangle) const {
        __builtin_prefetch(&data_.topology.edges_of_triangle[triangle.index]);
    }
    [[gnu::always_inline]] void prefetch_records(const MixedTriangle& triangle) const {
        for (std::uint32_t v : triangle.corners) {
            __builtin_prefetch(&data_.vertices[v]);
            __builtin_prefetch(&data_.vertices[v].slope_scale);  // often in the next cache line
            __builtin_prefetch(&values_[v]);
        }
        for (std::uint32_t e : data_.topology.edges_of_triangle[triangle.index])
            __builtin_prefetch(&graph_.crossing_of_edge[e]);
    }

    void add(const MixedTriangle& triangle) {
        const Triangle& t = triangle.corners;
        const Corner corners[3] = {corner(t[0]), corner(t[1]), corner(t[2])};
        float slope = 0;
        if (rules_.use_slope && !passes_gradient_tests(corners, slope)) return;
        std::uint32_t begin = 0, end = 0;
        for (int k = 0; k < 3; ++k) {
            const Corner &from = corners[(k + 1) % 3], &to = corners[(k + 2) % 3];
            if ((from.value < 0) == (to.value < 0)) continue;
            (from.value < 0 ? end : begin) =
                crossing(data_.topology.edges_of_triangle[triangle.index][k], from, to);
        }
        if (graph_.crossings[begin].accepted && graph_.crossings[end].accepted)
            graph_.segments.push_back({begin, end, slope});
    }

private:
    struct Corner {
        std::uint32_t vertex;
        float value;  // of the function whose zeros are looked for
        const VertexRecord& record;
        Eigen::Vector3f gradient;  // ∇I
    };

    Corner corner(std::uint32_t v) const {
        const VertexRecord& record = data_.vertices[v];
        return {v, values_[v].*function_, record,
                record.shape_operator * view_.light.towards(record.position)};  // ∇I = S l
    }

    std::uint32_t crossing(std::uint32_t edge, const Corner& from, const Corner& to) {
        std::uint32_t& index = graph_.crossing_of_edge[edge];
        if (index == CrossingGraph::kNoCrossing) {
            index = std::uint32_t(graph_.crossings.size());
            // The smaller vertex first, so that both triangles would find the same numbers.
            const bool ordered = from.vertex < to.vertex;
            graph_.crossings.push_back(
                compute_crossing(edge, ordered ? from : to, ordered ? to : from));
        }
        return index;
    }

    Crossing compute_crossing(std::uint32_t edge, const Corner& a, const Corner& b) const {
        const float fa = std::abs(a.value), sum = fa + std::abs(b.value);
        const float t = std::isfinite(sum) ? fa / sum : 0.5f;  // sum > 0: one side is negative
        Crossing c;
        c.edge = edge;
        c.position = (1 - t) * a.record.position + t * b.record.position;
        const Eigen::Vector3f gradient = (1 - t) * a.gradient + t * b.gradient;
        c.gradient = gradient.norm();
        const float facing = (1 - t) * values_[a.vertex].facing + t * values_[b.vertex].facing;
        c.accepted = c.gradient >= rules_.least_gradient &&
                     facing >= rules_.least_facing * view_.eye.towards(c.position).norm();
        c.opacity = clearance_opacity(facing, c.gradient, rules_.contour_clearance);
        if (rules_.concave_only) {
            const float lit =
                view_.light_at_eye ? facing : (1 - t) * lit_from_light(a) + t * lit_from_light(b);
            const float concavity = concavity_opacity(c, gradient, lit);
            c.accepted = c.accepted && concavity > 0;
            c.opacity *= concavity;
        }
        return c;
    }

    /// n·l for a light elsewhere than at the eye.
    float lit_from_light(const Corner& corner) const {
        const LinearForms& n = data_.normals;
        const std::uint32_t v = corner.vertex;
        const Eigen::Vector3f& light = view_.light.eye;
        return n.x[v] * light.x() + n.y[v] * light.y() + n.z[v] * light.z() -
               view_.light.w * n.offset[v];
    }

    /// Fades in where the surface turns from convex to concave. The measure is the cosine between
    /// −∇I and the tangential part w of the light vector: −w·Sw/(‖w‖‖Sw‖), with ∇I = Sw. `lit`
    /// is n·l.
    float concavity_opacity(const Crossing& c, const Eigen::Vector3f& gradient, float lit) const {
        const Eigen::Vector3f light = view_.light.towards(c.position);
        const float tangential = std::sqrt(std::max(light.squaredNorm() - lit * lit, 0.f));
        const float concavity = -light.dot(gradient) / (tangential * c.gradient);
        const float begin = -rules_.fading / 4, end = rules_.fading / 2;
        if (!(concavity > begin)) return 0;  // false for NaN, too: nothing to see from above
        return end > begin ? std::min((concavity - begin) / (end - begin), 1.f) : 1;
    }

    /// Slope of the function across the line, and whether the illumination's gradient is largest
    /// there (edge) or smallest (phantom).
    bool passes_gradient_tests(const Corner corners[3], float& slope) const {
        const Corner &a = corners[0], &b = corners[1], &c = corners[2];
        const Eigen::Vector3f u = b.record.position - a.record.position;
        const Eigen::Vector3f v = c.record.position - a.record.position;
        const Eigen::Vector3f area = u.cross(v);
        const float fu = b.value - a.value, fv = c.value - a.value;
        // ∇f of the linear interpolant: (fu·(v × N) + fv·(N × u)) / |N|², N = u × v.
        const Eigen::Vector3f df = (fu * v.cross(area) + fv * area.cross(u)) / area.squaredNorm();
        slope =
            df.norm() * (a.record.slope_scale + b.record.slope_scale + c.record.slope_scale) / 3;
        if (!(slope >= rules_.segment_slope)) return false;  // false for a sliver's NaN, too
        return !rules_.reject_phantoms || df.dot(a.gradient + b.gradient + c.gradient) <= 0;
    }

    const ExtractorData& data_;
    const LocalView& view_;
    const LineRules& rules_;
    const std::vector<VertexValue>& values_;
    const LineFunction function_;
    CrossingGraph& graph_;
};

}  // namespace

void find_segments(const ExtractorData& data, const LocalView& view, const LineRules& rules,
                   const VertexValues& values, LineFunction function,
                   const std::vector<MixedTriangle>& triangles, CrossingGraph& graph) {
    if (graph.in_use || graph.crossing_of_edge.size() != data.topology.edge_count)
        graph.crossing_of_edge.assign(data.topology.edge_count, CrossingGraph::kNoCrossing);
    graph.crossings.clear();
    graph.segments.clear();
    graph.in_use = true;
    SegmentFinder finder(data, view, rules, values, function, graph);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (i + 2 * kPrefetchDistance < triangles.size()) {
            finder.prefetch_edges(triangles[i + 2 * kPrefetchDistance]);
            finder.prefetch_records(triangles[i + kPrefetchDistance]);
        }
        finder.add(triangles[i]);
    }
    for (const Crossing& c : graph.crossings)
        graph.crossing_of_edge[c.edge] = CrossingGraph::kNoCrossing;
    graph.in_use = false;
}

}  // namespace laplacian_lines
