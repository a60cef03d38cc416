// SPDX-License-Identifier: GPL-3.0-or-later
#include "helpers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>

#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/tangent_frame.h"

namespace helpers {

using namespace laplacian_lines;

namespace {

using Numbers = std::function<Eigen::MatrixXd(std::size_t)>;

/// Of any numbers by vertex.
double error_of(std::size_t count, const Numbers& got, const Numbers& expected,
                const std::vector<bool>& use = {}) {
    double error = 0, size = 0;
    for (std::size_t v = 0; v < count; ++v) {
        if (!use.empty() && !use[v]) continue;
        error += (got(v) - expected(v)).squaredNorm();
        size += expected(v).squaredNorm();
    }
    return std::sqrt(error / size);
}

/// C in the frame of a normal, as Field::curvature_derivatives has it.
Eigen::Vector4d derivative_entries(const std::array<Eigen::Matrix3d, 3>& derivative,
                                   const Eigen::Vector3f& normal) {
    const TangentFrame frame = tangent_frame(normal);
    const Eigen::Vector3d u = frame.u.cast<double>(), v = frame.v.cast<double>();
    const auto along = [&](const Eigen::Vector3d& x) -> Eigen::Matrix3d {
        return x.x() * derivative[0] + x.y() * derivative[1] + x.z() * derivative[2];
    };
    return {u.dot(along(u) * u), u.dot(along(u) * v), v.dot(along(u) * v), v.dot(along(v) * v)};
}

}  // namespace

double relative_error(const std::vector<Eigen::Vector3f>& a,
                      const std::vector<Eigen::Vector3d>& b) {
    return error_of(
        b.size(), [&](std::size_t v) -> Eigen::MatrixXd { return a[v].cast<double>(); },
        [&](std::size_t v) -> Eigen::MatrixXd { return b[v]; });
}

double laplacian_error(const Field& field, const std::vector<test_meshes::SurfacePoint>& truth,
                       const std::vector<bool>& use) {
    return error_of(
        truth.size(),
        [&](std::size_t v) -> Eigen::MatrixXd { return field.laplacian_normals[v].cast<double>(); },
        [&](std::size_t v) -> Eigen::MatrixXd { return truth[v].laplacian_normal; }, use);
}

double shape_error(const Field& field, const std::vector<test_meshes::SurfacePoint>& truth) {
    return error_of(
        truth.size(),
        [&](std::size_t v) -> Eigen::MatrixXd { return matrix(field.shape_operators[v]); },
        [&](std::size_t v) -> Eigen::MatrixXd { return truth[v].shape_operator; });
}

double derivative_error(const Field& field, const std::vector<test_meshes::SurfacePoint>& truth) {
    const Eigen::Array4d weights(1, std::sqrt(3), std::sqrt(3), 1);  // for all eight entries
    return error_of(
        truth.size(),
        [&](std::size_t v) -> Eigen::MatrixXd {
            return (field.curvature_derivatives.at(v).cast<double>().array() * weights).matrix();
        },
        [&](std::size_t v) -> Eigen::MatrixXd {
            const Eigen::Vector4d entries =
                derivative_entries(truth[v].shape_derivative, field.normals[v]);
            return (entries.array() * weights).matrix();
        });
}

Eigen::Vector3d curvature_entries(const Eigen::Matrix3d& s, const Eigen::Vector3f& normal) {
    const TangentFrame frame = tangent_frame(normal);
    const Eigen::Vector3d u = frame.u.cast<double>(), v = frame.v.cast<double>();
    return {u.dot(s * u), u.dot(s * v), v.dot(s * v)};
}

Eigen::Matrix3d matrix(const ShapeOperator& s) {
    Eigen::Matrix3d m;
    m << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
    return m;
}

bool has_area(const TriangleMesh& mesh, const Triangle& t) {
    const auto& p = mesh.positions;
    for (std::uint32_t v : t)
        if (!p[v].allFinite()) return false;
    return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm() > 0;
}

PrecomputeOptions uncorrected_options(double kernel_size) {
    PrecomputeOptions options;
    options.kernel_size = kernel_size;
    options.normal_smoothing = NormalSmoothing::None;
    options.correct_borders = false;
    options.skip_opposite_sheet = false;
    return options;
}

LineStyle all_crossings() {
    LineStyle style;
    style.gradient_threshold = style.strength_threshold = 0;
    style.reject_phantoms = style.single_strokes = false;
    style.line_smoothing = 0;
    style.shows[LineKind::Ridge] = style.shows[LineKind::Border] = style.shows[LineKind::Crease] =
        false;
    style.segment_slope = style.line_slope = 0;
    style.shortest_line = style.shortest_contour = 0;
    style.least_facing = -1;
    style.contour_clearance = 0;  // which would drop lines that face away
    style.exact_outlines = false;
    return style;
}

LineStyle all_laplacian_lines() {
    LineStyle style = all_crossings();
    style.shows[LineKind::Contour] = false;
    return style;
}

LineStyle all_contours() {
    LineStyle style = all_crossings();
    style.shows[LineKind::Laplacian] = false;
    return style;
}

LineStyle all_crossings_of_all_kinds() {
    LineStyle style = all_crossings();
    style.shows = laplacian_lines::all_kinds();
    style.suggestive_slope = style.apparent_curvature = style.apparent_slope = 0;
    style.photic_slope = style.demarcation = 0;
    return style;
}

LineStyle all_kinds() {
    LineStyle style;
    style.shows = laplacian_lines::all_kinds();
    return style;
}

LineStyle only(LineKind kind) {
    LineStyle style;
    style.shows = only_kinds({kind});
    return style;
}

bool lies_on_the_surface(LineKind kind) {
    return kind == LineKind::Ridge || kind == LineKind::Valley || kind == LineKind::Border ||
           kind == LineKind::Crease || kind == LineKind::DemarcatingCurve;
}

Field true_field(const test_meshes::AnalyticMesh& surface, const FieldScale& scale) {
    Field field;
    field.scale = scale;
    for (const test_meshes::SurfacePoint& p : surface.truth) {
        const Eigen::Matrix3f s = p.shape_operator.cast<float>();
        field.normals.push_back(p.normal.cast<float>());
        field.laplacian_normals.push_back(p.laplacian_normal.cast<float>());
        field.shape_operators.push_back({s(0, 0), s(1, 1), s(2, 2), s(1, 2), s(0, 2), s(0, 1)});
        field.smooth_curvatures.push_back(
            curvature_entries(p.shape_operator, field.normals.back()).cast<float>());
        field.curvature_derivatives.push_back(
            derivative_entries(p.shape_derivative, field.normals.back()).cast<float>());
    }
    return field;
}

Field complete_field(const TriangleMesh& mesh, PrecomputeOptions options) {
    options.curvature_derivatives = true;
    return precompute(mesh, options);
}

LineSet extract(const LineExtractor& extractor, const View& view, const LineStyle& style) {
    ExtractionScratch scratch;
    LineSet lines;
    extractor.extract(view, style, scratch, lines);
    return lines;
}

float total_length(const LineSet& lines) {
    float sum = 0;
    for (const Polyline& line : lines.lines)
        sum += line.length;
    return sum;
}

std::vector<View> random_views(const TriangleMesh& mesh, int count) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : mesh.positions)
        if (p.allFinite() && p.norm() < 1e4) box.extend(p);  // not the unused one of with_dirt()
    std::mt19937 random(11);
    const auto unit = [&] { return test_meshes::signed_unit(random); };
    std::vector<View> views;
    for (int i = 0; i < count; ++i) {
        const double z = unit(), y = unit(), x = unit();
        const Eigen::Vector3d direction = Eigen::Vector3d(x, y, z).normalized();
        const double distance = box.diagonal().norm() * (0.6 + 2 * std::pow(unit() + 1, 2));
        views.push_back(i % 4 == 3 ? View::orthographic(direction * 3)
                                   : View::perspective(box.center() + distance * direction));
    }
    return views;
}

double length_of(const std::vector<ViewLine>& lines, const Counts& counts) {
    double length = 0;
    for (const ViewLine& line : lines)
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const Eigen::Vector3d &a = line.points[i - 1].position, &b = line.points[i].position;
            if (counts(line, a) && counts(line, b)) length += (b - a).norm();
        }
    return length;
}

double distance_to_lines(const Eigen::Vector3d& p, const LineSet& lines) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Polyline& line : lines.lines)
        for (std::uint32_t i = line.first; i + 1 < line.first + line.count; ++i) {
            const Eigen::Vector3d a = lines.position(lines.points[i]);
            const Eigen::Vector3d d = lines.position(lines.points[i + 1]) - a;
            const double t =
                d.squaredNorm() > 0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0., 1.) : 0;
            nearest = std::min(nearest, (p - a - t * d).squaredNorm());
        }
    return std::sqrt(nearest);
}

std::multiset<Edge> edges_of(const TriangleMesh& mesh, const LineSet& lines) {
    const auto find = [&](const Eigen::Vector3f& p) {
        for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
            if ((p - mesh.positions[v].cast<float>()).norm() < 1e-5) return v;
        throw std::logic_error("a point that is not a vertex");
    };
    std::multiset<Edge> edges;
    for (const Polyline& line : lines.lines)
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i)
            edges.insert(
                std::minmax(find(lines.points[i - 1].position), find(lines.points[i].position)));
    return edges;
}

std::vector<Edge> horizon_of(const TriangleMesh& mesh, const View& view) {
    std::map<Edge, std::vector<bool>> sides;
    for (const Triangle& t : mesh.triangles) {
        const auto& p = mesh.positions;
        const Eigen::Vector3d n = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
        const bool faces_eye = n.dot(view.eye - view.w * p[t[0]]) >= 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            sides[std::minmax(a, b)].push_back(faces_eye == (a < b));
        }
    }
    std::vector<Edge> edges;
    for (const auto& [edge, side] : sides)
        if (side.size() == 2 && side[0] == side[1]) edges.push_back(edge);
    return edges;
}

bool same_lines(const LineSet& a, const LineSet& b) {
    const auto same_point = [](const LinePoint& p, const LinePoint& q) {
        return p.position == q.position && p.weight == q.weight && p.gradient == q.gradient &&
               p.opacity == q.opacity;
    };
    const auto same_line = [](const Polyline& p, const Polyline& q) {
        return p.first == q.first && p.count == q.count && p.kind == q.kind &&
               p.closed == q.closed && p.strength == q.strength && p.length == q.length &&
               p.slope == q.slope;
    };
    return a.origin == b.origin &&
           std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                      same_point) &&
           std::equal(a.lines.begin(), a.lines.end(), b.lines.begin(), b.lines.end(), same_line);
}

bool same_fields(const Field& a, const Field& b) {
    const auto same = [&](const FieldColumn& column) {
        const std::size_t size = column.size(a);
        return size == column.size(b) &&
               (size == 0 || !std::memcmp(column.read(a), column.read(b),
                                          size * std::size_t(column.floats) * sizeof(float)));
    };
    return std::all_of(kFieldColumns.begin(), kFieldColumns.end(), same);
}

}  // namespace helpers
