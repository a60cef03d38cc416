// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawn_view.h"

namespace line_drawing {
namespace {

using laplacian_lines::LineKind;
using laplacian_lines::LinePoint;
using laplacian_lines::LineSet;
using laplacian_lines::Polyline;
using laplacian_lines::TriangleMesh;

constexpr double faintest_inner_line = 0.5;  // mean share of the full width

double widthOf(const LinePoint& point) {
    return double(point.weight) * double(point.opacity);
}

double meanWidth(const LineSet& lines, const Polyline& line) {
    double sum = 0;
    for (std::uint32_t i = 0; i < line.count; ++i)
        sum += widthOf(lines.points[line.first + i]);
    return sum / line.count;
}

LineClass classOf(const LineSet& lines, const Polyline& line) {
    if (laplacian_lines::describe(line.kind).is_outline) return LineClass::Outline;
    const bool is_faint =
        line.kind == LineKind::Laplacian && meanWidth(lines, line) < faintest_inner_line;
    return is_faint ? LineClass::Fine : LineClass::Inner;
}

}  // namespace

std::vector<Eigen::Vector2d> positionsOf(const DrawnLine& line) {
    std::vector<Eigen::Vector2d> positions;
    for (const DrawnPoint& point : line.points)
        positions.push_back(point.position);
    return positions;
}

Eigen::AlignedBox3d boundsOf(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const laplacian_lines::Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
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

std::vector<DrawnLine> project(const LineSet& lines, const Projection& projection, double unit) {
    std::vector<DrawnLine> drawn;
    for (const Polyline& line : lines.lines) {
        drawn.push_back({classOf(lines, line), line.closed, {}});
        drawn.back().points.reserve(line.count);
        for (std::uint32_t i = 0; i < line.count; ++i) {
            const LinePoint& point = lines.points[line.first + i];
            drawn.back().points.push_back(
                {unit * projection(point.position.cast<double>()), widthOf(point)});
        }
    }
    return drawn;
}

}  // namespace line_drawing
