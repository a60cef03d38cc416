// SPDX-License-Identifier: GPL-3.0-or-later
// Zero crossings on edges and their tests: L. Zhang, Y. He, H. S. Seah, "Laplacian Lines for
// Real-Time Shape Illustration", steps 1 and 2 of the extraction.
#include "crossings.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace laplacian_lines {

LineRules laplacian_rules(const LineStyle& s) {
    return {LineKind::Laplacian,      float(s.gradient_threshold),
            float(s.least_facing),    s.reject_phantoms,
            true,                     float(s.segment_slope),
            float(s.line_slope),      float(s.full_slope),
            float(s.strength_threshold), float(s.shortest_line)};
}

LineRules contour_rules(const LineStyle& s) {
    constexpr float kAnything = std::numeric_limits<float>::lowest();
    return {LineKind::Contour, kAnything, kAnything, false, false, kAnything, kAnything,
            1,                 kAnything, float(s.shortest_contour)};
}

void evaluate_vertices(const ExtractorData& data, const LocalEye& eye, const LineStyle& style,
                       VertexValues& values) {
    const std::size_t n = data.vertex_count();
    values.laplacian.resize(n);
    values.illumination.resize(n);
    values.facing.resize(n);
    values.signs.resize(n);
    const float ex = eye.eye.x(), ey = eye.eye.y(), ez = eye.eye.z(), w = eye.w;
    const Vectors &p = data.positions, &normal = data.normals, &laplacian = data.laplacians;
    for (std::size_t i = 0; i < n; ++i) {
        const float lx = ex - w * p.x[i], ly = ey - w * p.y[i], lz = ez - w * p.z[i];
        const float length = std::sqrt(lx * lx + ly * ly + lz * lz);
        const float illumination = normal.x[i] * ex + normal.y[i] * ey + normal.z[i] * ez -
                                   w * data.normal_offsets[i];
        values.illumination[i] = illumination;
        values.facing[i] = length > 0 ? illumination / length : 1.f;
        values.laplacian[i] = laplacian.x[i] * ex + laplacian.y[i] * ey + laplacian.z[i] * ez -
                              w * data.laplacian_offsets[i];
    }
    if (style.exact_point_light)  // the cross term that the paper's derivation loses
        for (std::size_t i = 0; i < n; ++i)
            values.laplacian[i] -= w * data.shape_operators[i].trace();
    const float least_facing = float(style.least_facing);
    for (std::size_t i = 0; i < n; ++i)
        values.signs[i] = std::uint8_t((values.laplacian[i] < 0 ? kNegativeLaplacian : 0) |
                                       (values.illumination[i] < 0 ? kNegativeIllumination : 0) |
                                       (values.facing[i] < least_facing ? kFacesAway : 0));
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
        if (!(differing & (kNegativeLaplacian | kNegativeIllumination))) continue;
        if ((differing & kNegativeLaplacian) && !(a & b & c & kFacesAway))
            mixed.laplacian.push_back(i);
        if (differing & kNegativeIllumination) mixed.contour.push_back(i);
    }
}

namespace {

class SegmentFinder {
public:
    SegmentFinder(const ExtractorData& data, const LocalEye& eye, const LineRules& rules,
                  const VertexValues& values, const std::vector<float>& function,
                  CrossingGraph& graph)
        : data_(data), eye_(eye), rules_(rules), values_(values), f_(function), graph_(graph) {}

    void add_triangle(std::uint32_t index) {
        const Triangle& t = data_.triangles[index];
        const bool negative[3] = {f_[t[0]] < 0, f_[t[1]] < 0, f_[t[2]] < 0};
        std::uint32_t begin = 0, end = 0;
        for (int k = 0; k < 3; ++k) {
            const bool from = negative[(k + 1) % 3], to = negative[(k + 2) % 3];
            if (from == to) continue;
            const std::uint32_t c = crossing(data_.topology.edges_of_triangle[index][k]);
            (from ? end : begin) = c;
        }
        if (!graph_.crossings[begin].accepted || !graph_.crossings[end].accepted) return;
        float slope = 0;
        if ((rules_.use_slope || rules_.reject_phantoms) && !passes_gradient_tests(t, slope))
            return;
        graph_.segments.push_back({begin, end, slope});
    }

private:
    Eigen::Vector3f light(std::uint32_t v) const { return eye_.eye - eye_.w * data_.positions[v]; }
    /// ∇I = S l.
    Eigen::Vector3f gradient(std::uint32_t v) const { return data_.shape_operators[v] * light(v); }

    std::uint32_t crossing(std::uint32_t edge) {
        std::uint32_t& index = graph_.crossing_of_edge[edge];
        if (index == CrossingGraph::kNoCrossing) {
            index = std::uint32_t(graph_.crossings.size());
            graph_.crossings.push_back(compute_crossing(edge));
        }
        return index;
    }

    Crossing compute_crossing(std::uint32_t edge) const {
        const auto [a, b] = data_.topology.edges[edge];
        const float fa = std::abs(f_[a]), sum = fa + std::abs(f_[b]);
        const float t = std::isfinite(sum) ? fa / sum : 0.5f;  // sum > 0: one side is negative
        Crossing c;
        c.edge = edge;
        c.position = (1 - t) * data_.positions[a] + t * data_.positions[b];
        c.gradient = ((1 - t) * gradient(a) + t * gradient(b)).norm();
        const float facing = (1 - t) * values_.facing[a] + t * values_.facing[b];
        c.accepted = c.gradient >= rules_.least_gradient && facing >= rules_.least_facing;
        return c;
    }

    /// Slope of the function across the line, and whether the illumination's gradient is largest
    /// there (edge) or smallest (phantom).
    bool passes_gradient_tests(const Triangle& t, float& slope) const {
        const Eigen::Vector3f a = data_.positions[t[0]];
        const Eigen::Vector3f u = data_.positions[t[1]] - a, v = data_.positions[t[2]] - a;
        const Eigen::Vector3f area = u.cross(v);
        const float squared = area.squaredNorm();
        const float fu = f_[t[1]] - f_[t[0]], fv = f_[t[2]] - f_[t[0]];
        // ∇f of the linear interpolant: (fu·(v × N) + fv·(N × u)) / |N|², N = u × v.
        const Eigen::Vector3f df = (fu * v.cross(area) + fv * area.cross(u)) / squared;
        const float scale =
            (data_.slope_scale[t[0]] + data_.slope_scale[t[1]] + data_.slope_scale[t[2]]) / 3;
        slope = df.norm() * scale;
        if (!(slope >= rules_.segment_slope)) return false;  // also drops slivers' infinities
        return !rules_.reject_phantoms ||
               df.dot(gradient(t[0]) + gradient(t[1]) + gradient(t[2])) <= 0;
    }

    const ExtractorData& data_;
    const LocalEye& eye_;
    const LineRules& rules_;
    const VertexValues& values_;
    const std::vector<float>& f_;
    CrossingGraph& graph_;
};

}  // namespace

void find_segments(const ExtractorData& data, const LocalEye& eye, const LineRules& rules,
                   const VertexValues& values, const std::vector<float>& function,
                   const std::vector<std::uint32_t>& triangles, CrossingGraph& graph) {
    if (graph.in_use || graph.crossing_of_edge.size() != data.topology.edges.size())
        graph.crossing_of_edge.assign(data.topology.edges.size(), CrossingGraph::kNoCrossing);
    graph.crossings.clear();
    graph.segments.clear();
    graph.in_use = true;
    SegmentFinder finder(data, eye, rules, values, function, graph);
    for (std::uint32_t t : triangles) finder.add_triangle(t);
    for (const Crossing& c : graph.crossings)
        graph.crossing_of_edge[c.edge] = CrossingGraph::kNoCrossing;
    graph.in_use = false;
}

}  // namespace laplacian_lines
