// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/drawn_view.h"

#include <algorithm>

namespace line_drawing {
namespace {

using laplacian_lines::LineKind;
using laplacian_lines::SightLine;
using laplacian_lines::SightPoint;
using laplacian_lines::TriangleMesh;

constexpr double faintest_inner_line = 0.5;  // mean share of the full width

double widthOf(const SightPoint& point) {
    return double(point.weight) * double(point.opacity);
}

double meanWidth(const SightLine& line) {
    double sum = 0;
    for (const SightPoint& point : line.points)
        sum += widthOf(point);
    return sum / double(line.points.size());
}

LineClass classOf(const SightLine& line) {
    if (line.is_hidden) return LineClass::Hidden;
    if (line.is_outline) return LineClass::Outline;
    if (laplacian_lines::describe(line.kind).is_outline) return LineClass::Contour;
    if (line.kind == LineKind::Crease) return LineClass::Edge;
    const bool is_faint = line.kind == LineKind::Laplacian && meanWidth(line) < faintest_inner_line;
    return is_faint ? LineClass::Fine : LineClass::Inner;
}

}  // namespace

std::vector<Eigen::Vector2d> positionsOf(const DrawnLine& line) {
    std::vector<Eigen::Vector2d> positions;
    for (const DrawnPoint& point : line.points)
        positions.push_back(point.position);
    return positions;
}

double lengthOf(const std::vector<DrawnPoint>& points, std::size_t begin) {
    double length = 0;
    for (std::size_t i = begin + 1; i < points.size(); ++i)
        length += (points[i].position - points[i - 1].position).norm();
    return length;
}

Eigen::Vector2d outwardsAt(const std::vector<DrawnPoint>& points, bool is_last, double reach) {
    const auto at = [&](std::size_t k) -> const Eigen::Vector2d& {
        return points[is_last ? points.size() - 1 - k : k].position;
    };
    std::size_t k = 1;
    while (k + 1 < points.size() && (at(k) - at(0)).norm() < reach)
        ++k;
    return (at(0) - at(k)).stableNormalized();
}

void shiftEnd(std::vector<DrawnPoint>& points, bool is_last, const Eigen::Vector2d& shift,
              double reach) {
    double length = 0;
    for (std::size_t k = 0; k < points.size() && length < reach; ++k) {
        const std::size_t i = is_last ? points.size() - 1 - k : k;
        const Eigen::Vector2d before = points[i].position;
        points[i].position += (1 - length / reach) * shift;
        if (k + 1 < points.size())
            length += (points[is_last ? i - 1 : i + 1].position - before).norm();
    }
}

bool isFixed(const DrawnLine& line) {
    return std::all_of(line.points.begin(), line.points.end(),
                       [](const DrawnPoint& point) { return point.stays(); });
}

bool isSmooth(const DrawnLine& line) {
    return std::any_of(line.points.begin(), line.points.end(),
                       [](const DrawnPoint& point) { return !point.is_exact; });
}

bool isInner(const DrawnLine& line) {
    return (line.line_class == LineClass::Inner || line.line_class == LineClass::Fine) &&
           isSmooth(line);
}

Eigen::AlignedBox3d boundsOf(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const laplacian_lines::Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle)
            if (v < mesh.positions.size() && mesh.positions[v].allFinite())
                box.extend(mesh.positions[v]);
    return box;
}

DrawnLine project(const std::vector<Eigen::Vector3d>& section, const Projection& projection,
                  double unit) {
    DrawnLine drawn{
        LineClass::Section, section.size() > 3 && section.front() == section.back(), {}};
    for (const Eigen::Vector3d& p : section)
        drawn.points.push_back({unit * projection(p), 1});
    return drawn;
}

std::vector<DrawnLine> project(const std::vector<SightLine>& lines, const Projection& projection,
                               double unit) {
    std::vector<DrawnLine> drawn;
    for (const SightLine& line : lines) {
        drawn.push_back({classOf(line), line.closed, {}, unit * double(line.jump)});
        drawn.back().points.reserve(line.points.size());
        for (const SightPoint& point : line.points)
            drawn.back().points.push_back(
                {unit * projection(point.position), widthOf(point), point.node, point.is_exact});
    }
    return drawn;
}

}  // namespace line_drawing
