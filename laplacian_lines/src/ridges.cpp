// SPDX-License-Identifier: GPL-3.0-or-later
#include "ridges.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "polyline_tracing.h"

namespace laplacian_lines {
namespace {

constexpr float kDegrees = 57.29577951308232f;
constexpr float kDominance = 2;

/// The sharpest bend at a vertex.
struct Bend {
    Eigen::Vector3f direction = Eigen::Vector3f::Zero();  ///< e₁, unit, of either sign
    float angle = 0;       ///< 2 k₁ √h in degrees; 0: no candidate
    float derivative = 0;  ///< ∇(tr S)·e₁
    float curvature = 0;   ///< k₁
};

Eigen::Matrix3f matrix(const ShapeOperator& s) {
    Eigen::Matrix3f m;
    m << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
    return m;
}

Bend bend(const WholeMesh& mesh, std::size_t v) {
    const WholeMesh::Vertex& record = mesh.vertices[v];
    const float size = std::cbrt(record.slope_scale);  // √h_e
    const ShapeOperator& s = record.shape_operator;
    const float frobenius = std::sqrt(s.xx * s.xx + s.yy * s.yy + s.zz * s.zz +
                                      2 * (s.yz * s.yz + s.xz * s.xz + s.xy * s.xy));
    if (!(2 * frobenius * size * kDegrees >= kLeastRidgeAngle)) return {};
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
    solver.computeDirect(matrix(s));
    const Eigen::Vector3f k = solver.eigenvalues();  // ascending; one of them is the normal's 0
    Bend bend;
    bend.curvature = k[2];
    bend.angle = 2 * k[2] * size * kDegrees;
    if (!(bend.angle >= kLeastRidgeAngle) || !(k[2] > kDominance * -k[0]) ||
        !(k[2] > kDominance * k[1]))
        return {};
    bend.direction = solver.eigenvectors().col(2);
    bend.derivative = bend.direction.dot(record.laplacian);
    return bend;
}

/// Collects the pieces of ridges in triangles.
class RidgeFinder {
public:
    explicit RidgeFinder(const WholeMesh& mesh) : mesh_(mesh), bends_(mesh.vertices.size()) {
        for (std::size_t v = 0; v < bends_.size(); ++v)
            bends_[v] = bend(mesh, v);
        crossing_of_edge_.assign(mesh.topology.edge_count, CrossingGraph::kNoCrossing);
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            add(t);
    }
    const CrossingGraph& graph() const { return graph_; }
    /// Of the crossing that a traced point comes from. Above 2^24 crossings, of one beside it.
    float angle(const LinePoint& point) const { return angles_[number(point)]; }
    const Ridges::Form& form(const LinePoint& point) const { return forms_[number(point)]; }

private:
    void add(std::uint32_t index) {
        const Triangle& t = mesh_.triangles[index];
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
        std::uint32_t ends[2];
        int found = 0;
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            if ((f[i] < 0) == (f[j] < 0)) continue;
            ends[found++] = crossing(mesh_.topology.edges_of_triangle[index][std::size_t(k)],
                                     t[std::size_t(i)], t[std::size_t(j)]);
        }
        graph_.segments.push_back({ends[0], ends[1], 0});
    }

    static float sign_to(const Bend& a, const Bend& b) {
        return a.direction.dot(b.direction) < 0 ? -1.f : 1.f;
    }

    /// Whether the linear interpolant of f falls along e: a maximum of the curvature.
    bool falls_along(const Triangle& t, const float f[3], const Eigen::Vector3f& e) const {
        const Eigen::Vector3f a = mesh_.vertices[t[0]].position;
        const Eigen::Vector3f u = mesh_.vertices[t[1]].position - a;
        const Eigen::Vector3f v = mesh_.vertices[t[2]].position - a;
        const Eigen::Vector3f area = u.cross(v);
        const Eigen::Vector3f df = (f[1] - f[0]) * v.cross(area) + (f[2] - f[0]) * area.cross(u);
        return df.dot(e) < 0;
    }

    std::uint32_t crossing(std::uint32_t edge, std::uint32_t a, std::uint32_t b) {
        std::uint32_t& index = crossing_of_edge_[edge];
        if (index == CrossingGraph::kNoCrossing) {
            index = std::uint32_t(graph_.crossings.size());
            if (b < a) std::swap(a, b);
            const float fa = std::abs(bends_[a].derivative),
                        sum = fa + std::abs(bends_[b].derivative);
            const float t = sum > 0 ? fa / sum : 0.5f;
            Crossing c;
            c.position = (1 - t) * mesh_.vertices[a].position + t * mesh_.vertices[b].position;
            // Its number travels through the tracing in place of a gradient.
            c.gradient = float(index);
            angles_.push_back((1 - t) * bends_[a].angle + t * bends_[b].angle);
            forms_.push_back(form(a, b, t));
            c.opacity = 1;
            graph_.crossings.push_back(c);
        }
        return index;
    }

    Ridges::Form form(std::uint32_t a, std::uint32_t b, float t) const {
        const Eigen::Vector3f bend_a = bends_[a].curvature * bends_[a].direction;
        const Eigen::Vector3f bend_b = bends_[b].curvature * bends_[b].direction;
        return {(1 - t) * mesh_.vertices[a].normal + t * mesh_.vertices[b].normal,
                (1 - t) * bend_a + t * sign_to(bends_[a], bends_[b]) * bend_b};
    }

    std::size_t number(const LinePoint& point) const {
        return std::min(std::size_t(point.gradient), forms_.size() - 1);
    }

    const WholeMesh& mesh_;
    std::vector<Bend> bends_;
    std::vector<std::uint32_t> crossing_of_edge_;
    CrossingGraph graph_;
    std::vector<float> angles_;  // by crossing
    std::vector<Ridges::Form> forms_;
};

}  // namespace

Ridges find_ridges(const ExtractorData& data, const WholeMesh& mesh) {
    const RidgeFinder finder(mesh);
    LineRules rules;
    rules.kind = LineKind::Ridge;
    TracingMemory memory;
    Ridges ridges;
    trace_polylines(data, rules, finder.graph(), memory, ridges.lines);
    for (LinePoint& point : ridges.lines.points) {
        ridges.forms.push_back(finder.form(point));
        point.gradient = finder.angle(point);
    }
    for (Polyline& line : ridges.lines.lines)
        line.strength = 0;
    return ridges;
}

}  // namespace laplacian_lines
