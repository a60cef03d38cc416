// SPDX-License-Identifier: GPL-3.0-or-later
#include "crest_lines.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "joined_crossings.h"
#include "laplacian_lines/tangent_frame.h"

namespace benchmarks {

using namespace laplacian_lines;
using Eigen::Vector3d;

namespace {

const double kLeastTurn = std::sqrt(0.5);  // cosine between directions at corners
// Of k₁, the least difference to k₂: less is the mesh's share in what has no direction.
constexpr double kLeastAnisotropy = 0.05;

/// What counts of a vertex.
struct Crest {
    Vector3d direction = Vector3d::Zero();  ///< e₁, of either sign; 0: none rules
    double curvature = 0;                   ///< k₁
    double derivative = 0;                  ///< C(e₁, e₁, e₁)
};

/// `sign`: 1 for ridges, −1 for valleys.
Crest crest_at(const Field& field, std::size_t vertex, float sign) {
    const TangentFrame frame = tangent_frame(field.normals[vertex]);
    const ShapeOperator& s = field.shape_operators[vertex];
    Eigen::Matrix2d in_frame;
    in_frame << frame.u.dot(s * frame.u), frame.u.dot(s * frame.v), frame.v.dot(s * frame.u),
        frame.v.dot(s * frame.v);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal(sign * in_frame);
    const double k2 = principal.eigenvalues()[0], k1 = principal.eigenvalues()[1];
    if (!(k1 > std::abs(k2)) || k1 - k2 < kLeastAnisotropy * k1) return {};
    const double x = principal.eigenvectors()(0, 1), y = principal.eigenvectors()(1, 1);
    const Eigen::Vector4d c = sign * field.curvature_derivatives[vertex].cast<double>();
    return {x * frame.u.cast<double>() + y * frame.v.cast<double>(), k1,
            x * x * (c[0] * x + 3 * c[1] * y) + y * y * (3 * c[2] * x + c[3] * y)};
}

struct CrestPoint {
    Vector3d position;
    double curvature;
};

/// Finds the lines of one mesh.
class CrestFinding {
public:
    CrestFinding(const TriangleMesh& mesh, const Field& field, float sign) : mesh_(mesh) {
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            crests_.push_back(crest_at(field, v, sign));
        for (const Triangle& t : mesh.triangles)
            add_piece(t);
    }

    JoinedCrossings<CrestPoint>& crossings() { return crossings_; }

private:
    void add_piece(const Triangle& t) {
        Crest at[3];
        for (std::size_t k = 0; k < 3; ++k) {
            at[k] = crests_[t[k]];
            if (at[k].direction.dot(at[0].direction) < 0) {
                at[k].direction *= -1;
                at[k].derivative *= -1;
            }
        }
        for (std::size_t k = 0; k < 3; ++k)  // also where there is none
            if (!(at[k].direction.dot(at[(k + 1) % 3].direction) > kLeastTurn)) return;
        std::uint32_t ends[2];
        int found = 0;
        for (std::size_t k = 0; k < 3; ++k)
            if ((at[k].derivative < 0) != (at[(k + 1) % 3].derivative < 0) && is_maximum(t, at))
                ends[found++] = crossings_.on_edge(
                    t[k], t[(k + 1) % 3],
                    [&](std::uint32_t a, std::uint32_t b) { return zero_between(a, b); });
        if (found == 2) crossings_.join(ends[0], ends[1]);
    }

    /// Whether the linear function of the derivatives falls along the direction.
    bool is_maximum(const Triangle& t, const Crest at[3]) const {
        const Vector3d u = mesh_.positions[t[1]] - mesh_.positions[t[0]];
        const Vector3d v = mesh_.positions[t[2]] - mesh_.positions[t[0]];
        const Vector3d area = u.cross(v);
        const Vector3d gradient = (at[1].derivative - at[0].derivative) * v.cross(area) +
                                  (at[2].derivative - at[0].derivative) * area.cross(u);
        return gradient.dot(at[0].direction + at[1].direction + at[2].direction) < 0;
    }

    /// Of the derivative along an edge, for directions that agree.
    CrestPoint zero_between(std::uint32_t a, std::uint32_t b) const {
        const double fa = std::abs(crests_[a].derivative), fb = std::abs(crests_[b].derivative);
        const double s = fa + fb > 0 ? fa / (fa + fb) : 0.5;
        return {(1 - s) * mesh_.positions[a] + s * mesh_.positions[b],
                (1 - s) * crests_[a].curvature + s * crests_[b].curvature};
    }

    const TriangleMesh& mesh_;
    std::vector<Crest> crests_;
    JoinedCrossings<CrestPoint> crossings_;
};

/// Fills in what its points, up to `end`, say of a line.
void measure(Polyline& line, std::uint32_t end, const std::vector<LinePoint>& points,
             float diagonal) {
    line.count = end - line.first;
    for (std::uint32_t i = line.first + 1; i < end; ++i) {
        const LinePoint &a = points[i - 1], &b = points[i];
        const float length = (b.position - a.position).norm() / diagonal;
        line.length += length;
        line.strength += (a.gradient + b.gradient) / 2 * length;
    }
    line.closed = line.count > 3 && points[line.first].position == points[end - 1].position;
}

}  // namespace

LineSet crest_lines(const TriangleMesh& mesh, const Field& field, LineKind kind) {
    CrestFinding finding(mesh, field, kind == LineKind::Valley ? -1.f : 1.f);
    const auto diagonal = float(field.scale.diagonal);
    LineSet lines;
    finding.crossings().for_each_line(
        [&] {
            lines.lines.push_back({std::uint32_t(lines.points.size()), 0, kind});
        },
        [&](const CrestPoint& p) {
            lines.points.push_back({p.position.cast<float>(), 1, float(p.curvature) * diagonal, 1});
        });
    auto end = std::uint32_t(lines.points.size());
    for (auto line = lines.lines.rbegin(); line != lines.lines.rend(); ++line) {
        measure(*line, end, lines.points, diagonal);
        end = line->first;
    }
    return lines;
}

LineSet lines_of_strength(const LineSet& lines, double least) {
    LineSet kept;
    for (Polyline line : lines.lines) {
        if (double(line.strength) < least) continue;
        const auto first = lines.points.begin() + std::ptrdiff_t(line.first);
        line.first = std::uint32_t(kept.points.size());
        kept.points.insert(kept.points.end(), first, first + std::ptrdiff_t(line.count));
        kept.lines.push_back(line);
    }
    return kept;
}

double strength_for_length(const LineSet& lines, double length) {
    std::vector<std::pair<double, double>> strongest_first;  // −strength, length
    for (const Polyline& line : lines.lines)
        strongest_first.emplace_back(-line.strength, line.length);
    std::sort(strongest_first.begin(), strongest_first.end());
    double weakest_kept = std::numeric_limits<double>::infinity(), before = 0;
    for (const auto& [negative, added] : strongest_first) {
        if (before + added / 2 > length) return std::sqrt(weakest_kept * -negative);
        before += added;
        weakest_kept = -negative;
    }
    return 0;
}

}  // namespace benchmarks
