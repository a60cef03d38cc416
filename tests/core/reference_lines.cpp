// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "helpers.h"
#include "laplacian_lines/tangent_frame.h"
#include "reference.h"

namespace reference {

using namespace laplacian_lines;

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using helpers::Edge;

/// Lengths in D from the middle of the box.
struct Vertex {
    Vector3d position, normal, laplacian;
    Matrix3d shape_operator;
    double value = 0;  ///< of the function whose zeros are looked for
};

struct Crossing {
    Vector3d position, gradient;  ///< ∇I
    Vector3d towards_eye;
    double cosine;  ///< n·l/|l|
};

struct Segment {
    Edge edges[2];
    double slope;
};

/// The eye or the light as a homogeneous point, so that l has about the length 1.
struct Point {
    Vector3d e;
    double w;
    Vector3d from(const Vector3d& p) const { return e - w * p; }
};

class ZeroLines {
public:
    ZeroLines(const TriangleMesh& mesh, const Field& field, const View& view,
              const LineStyle& style, LineKind kind)
        : mesh_(mesh), style_(style), kind_(kind), diagonal_(diagonal(mesh)) {
        Eigen::AlignedBox3d box;
        for (const Vector3d& p : mesh.positions)
            box.extend(p);
        centre_ = box.center();
        eye_ = {view.eye.normalized(), 0};
        if (view.w != 0) {
            const Vector3d e = (view.eye / view.w - centre_) / diagonal_;
            eye_ = {e.normalized(), 1 / e.norm()};
        }
        light_ =
            view.light && kind == LineKind::Laplacian ? Point{view.light->normalized(), 0} : eye_;
        const auto squared_scale = [&](double size) {
            const double sigma = field.scale.normal_sigma;
            return (size * size + sigma * sigma / 2) / (diagonal_ * diagonal_);
        };
        const double size = field.scale.kernel_size,
                     derivative_scale = squared_scale(std::max(size, 2 * field.scale.mean_edge)),
                     share = squared_scale(size) / derivative_scale;
        slope_scale_ = std::pow(derivative_scale, 1.5);
        if (kind == LineKind::Laplacian) slope_scale_ *= std::pow(share, 1.5 * 0.75);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            vertices_.push_back(vertex(field, v));
    }

    std::vector<Line> find() {
        for (const Triangle& t : mesh_.triangles)
            add_segment(t);
        for (std::size_t i = 0; i < segments_.size(); ++i)
            for (const Edge& edge : segments_[i].edges)
                at_edge_[edge].push_back(i);
        std::vector<Line> lines;
        used_.assign(segments_.size(), false);
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            if (used_[i]) continue;
            const Line line = line_through(i);
            if (is_wanted(line)) lines.push_back(line);
        }
        return lines;
    }

private:
    Vertex vertex(const Field& field, std::size_t v) const {
        Vertex vertex;
        vertex.position = (mesh_.positions[v] - centre_) / diagonal_;
        vertex.normal = field.normals[v].cast<double>();
        vertex.laplacian = field.laplacian_normals[v].cast<double>() * diagonal_ * diagonal_;
        vertex.shape_operator = helpers::matrix(field.shape_operators[v]) * diagonal_;
        const Vector3d l = light_.from(vertex.position);
        if (kind_ == LineKind::Laplacian) {
            vertex.value = vertex.laplacian.dot(l);
        } else if (kind_ == LineKind::Contour) {
            vertex.value = vertex.normal.dot(l);
        } else {
            const Eigen::Vector2d w =
                tangent_frame(field.normals[v])(l.cast<float>()).cast<double>();
            const Vector3d c = field.smooth_curvatures[v].cast<double>() * diagonal_;
            vertex.value = c[0] * w.x() * w.x() + 2 * c[1] * w.x() * w.y() + c[2] * w.y() * w.y();
        }
        return vertex;
    }

    bool is_suggestive() const {
        return kind_ == LineKind::SuggestiveContour || kind_ == LineKind::SuggestiveHighlight;
    }

    Crossing crossing(const Edge& edge) const {
        const Vertex &a = vertices_[edge.first], &b = vertices_[edge.second];
        const double t = a.value / (a.value - b.value);
        const auto between = [&](const auto& x, const auto& y) {
            return ((1 - t) * x + t * y).eval();
        };
        Crossing c;
        c.position = between(a.position, b.position);
        c.gradient = between(a.shape_operator, b.shape_operator) * light_.from(c.position);
        c.towards_eye = eye_.from(c.position);
        c.cosine = between(a.normal, b.normal).dot(c.towards_eye) / c.towards_eye.norm();
        return c;
    }

    bool is_accepted(const Crossing& c) const {
        if (kind_ == LineKind::Contour) return true;
        if (is_suggestive()) return c.cosine >= 0;
        return c.cosine >= style_.least_facing && c.gradient.norm() >= style_.gradient_threshold;
    }

    void add_segment(const Triangle& t) {
        std::vector<Edge> edges;
        for (std::size_t k = 0; k < 3; ++k) {
            const Edge edge = std::minmax(t[k], t[(k + 1) % 3]);
            if ((vertices_[edge.first].value < 0) != (vertices_[edge.second].value < 0))
                edges.push_back(edge);
        }
        if (edges.empty()) return;
        const Crossing from = crossing(edges[0]), to = crossing(edges[1]);
        if (!is_accepted(from) || !is_accepted(to)) return;
        const double slope = slope_of(t, from, to);
        if (kind_ != LineKind::Contour && slope < 0) return;
        segments_.push_back({{edges[0], edges[1]}, slope});
    }

    /// Of the function in a triangle; negative where it is not to be drawn.
    double slope_of(const Triangle& t, const Crossing& from, const Crossing& to) const {
        const Vertex &a = vertices_[t[0]], &b = vertices_[t[1]], &c = vertices_[t[2]];
        const Vector3d u = b.position - a.position, v = c.position - a.position, n = u.cross(v);
        const Vector3d steepest =
            ((b.value - a.value) * v.cross(n) + (c.value - a.value) * n.cross(u)) / n.squaredNorm();
        if (is_suggestive()) {
            const double towards = steepest.dot(from.towards_eye + to.towards_eye);
            return kind_ == LineKind::SuggestiveContour ? towards : -towards;
        }
        if (kind_ == LineKind::Contour) return 0;
        const double slope = steepest.norm() * slope_scale_;
        const bool is_phantom = steepest.dot(from.gradient + to.gradient) > 0;
        return (style_.reject_phantoms && is_phantom) || slope < style_.segment_slope ? -1 : slope;
    }

    std::size_t next(std::size_t i, const Edge& edge) const {
        const auto& here = at_edge_.at(edge);
        if (here.size() != 2) return segments_.size();
        return here[0] == i ? here[1] : here[0];
    }

    /// Back to its start, or once around, then all of it.
    Line line_through(std::size_t i) {
        std::size_t first = i;
        int side = 0;  // where the first segment begins
        for (std::size_t j; (j = next(first, segments_[first].edges[side])) < segments_.size();) {
            side = segments_[j].edges[0] == segments_[first].edges[side] ? 1 : 0;
            first = j;
            if (first == i) break;
        }
        Line line;
        add_point(segments_[first].edges[side], line);
        for (i = first; i < segments_.size() && !used_[i];) {
            used_[i] = true;
            const Edge& end = segments_[i].edges[1 - side];
            add_point(end, line);
            const std::size_t n = line.points.size();
            const double length = (line.points[n - 1] - line.points[n - 2]).norm() / diagonal_;
            line.length += length;
            line.strength += (line.gradients[n - 1] + line.gradients[n - 2]) / 2 * length;
            line.slope += segments_[i].slope * length;
            i = next(i, end);
            line.closed = i == first;
            if (i < segments_.size()) side = segments_[i].edges[0] == end ? 0 : 1;
        }
        line.slope /= line.length;
        return line;
    }

    void add_point(const Edge& edge, Line& line) const {
        const Crossing c = crossing(edge);
        line.points.push_back(centre_ + diagonal_ * c.position);
        line.gradients.push_back(c.gradient.norm());
    }

    bool is_wanted(const Line& line) const {
        if (kind_ == LineKind::Contour) return line.length >= style_.shortest_contour;
        if (line.length < style_.shortest_line) return false;
        return is_suggestive() ||
               (line.strength >= style_.strength_threshold && line.slope >= style_.line_slope);
    }

    const TriangleMesh& mesh_;
    const LineStyle& style_;
    const LineKind kind_;
    const double diagonal_;
    double slope_scale_ = 0;  // h_e^1.5, of Laplacian lines as docs/algorithms.md has it
    Vector3d centre_;
    Point eye_, light_;
    std::vector<Vertex> vertices_;
    std::vector<Segment> segments_;
    std::map<Edge, std::vector<std::size_t>> at_edge_;
    std::vector<bool> used_;
};

}  // namespace

std::vector<Line> zero_lines(const TriangleMesh& mesh, const Field& field, const View& view,
                             const LineStyle& style, LineKind kind) {
    return ZeroLines(mesh, field, view, style, kind).find();
}

}  // namespace reference
