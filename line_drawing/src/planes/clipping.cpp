// SPDX-License-Identifier: GPL-3.0-or-later
// Lines, loops and meshes on one side of a plane. Lines fall into runs of points inside, whose ends
// are the crossings with the plane; a loop is one run that goes along the plane from end to end.
#include "planes/clipping.h"

#include <algorithm>
#include <utility>

namespace line_drawing {
namespace {

using Eigen::Vector3d;
using laplacian_lines::LinePoint;
using laplacian_lines::LineSet;
using laplacian_lines::Polyline;
using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;
using laplacian_lines::ViewLine;
using laplacian_lines::ViewLinePoint;

/// Less the set's origin.
Vector3d position_of(const LinePoint& p) {
    return p.position.cast<double>();
}
const Vector3d& position_of(const Vector3d& p) {
    return p;
}
const Vector3d& position_of(const ViewLinePoint& p) {
    return p.position;
}
Vector3d between(const Vector3d& a, const Vector3d& b, double t) {
    return (1 - t) * a + t * b;
}
float between(float a, float b, double t) {
    return float((1 - t) * double(a) + t * double(b));
}
LinePoint between(const LinePoint& a, const LinePoint& b, double t) {
    return {between(position_of(a), position_of(b), t).cast<float>(),
            between(a.weight, b.weight, t), between(a.gradient, b.gradient, t),
            between(a.opacity, b.opacity, t)};
}
ViewLinePoint between(const ViewLinePoint& a, const ViewLinePoint& b, double t) {
    return {between(a.position, b.position, t), between(a.weight, b.weight, t),
            between(a.gradient, b.gradient, t), between(a.opacity, b.opacity, t),
            laplacian_lines::kNoNode,           true};
}

template <class Point>
Point crossing(const Point& a, const Point& b, const HalfSpace& inside) {
    const double at_a = inside.depth(position_of(a)), at_b = inside.depth(position_of(b));
    return between(a, b, at_a / (at_a - at_b));
}

template <class Point>
std::vector<std::vector<Point>> runs_inside(const Point* points, std::size_t count,
                                            const HalfSpace& inside) {
    std::vector<std::vector<Point>> runs;
    bool was_inside = false;
    for (std::size_t i = 0; i < count; ++i) {
        const bool is_inside = inside.depth(position_of(points[i])) >= 0;
        if (is_inside && !was_inside) runs.emplace_back();
        if (i > 0 && is_inside != was_inside)
            runs.back().push_back(crossing(points[i - 1], points[i], inside));
        if (is_inside) runs.back().push_back(points[i]);
        was_inside = is_inside;
    }
    return runs;
}

/// Of a closed line. If only its first point is outside, which is also its last, a run is as long.
template <class Point>
bool is_whole(const std::vector<Point>& run, const Point& first, std::size_t count) {
    return run.size() == count && position_of(run[0]) == position_of(first);
}

}  // namespace

LineSet clip(const LineSet& lines, const HalfSpace& inside) {
    LineSet result;
    result.origin = lines.origin;
    const HalfSpace shifted{inside.normal, -inside.depth(lines.origin)};
    for (const Polyline& line : lines.lines)
        for (const auto& run : runs_inside(lines.points.data() + line.first, line.count, shifted)) {
            if (run.size() < 2) continue;
            Polyline part = line;
            part.first = std::uint32_t(result.points.size());
            part.count = std::uint32_t(run.size());
            part.closed = line.closed && is_whole(run, lines.points[line.first], line.count);
            result.points.insert(result.points.end(), run.begin(), run.end());
            result.lines.push_back(part);
        }
    return result;
}

std::vector<ViewLine> clip(const std::vector<ViewLine>& lines, const HalfSpace& inside) {
    std::vector<ViewLine> result;
    for (const ViewLine& line : lines)
        for (auto& run : runs_inside(line.points.data(), line.points.size(), inside)) {
            if (run.size() < 2) continue;
            ViewLine part = line;
            part.closed = line.closed && is_whole(run, line.points[0], line.points.size());
            part.points = std::move(run);
            result.push_back(std::move(part));
        }
    return result;
}

std::vector<Cut> clip(const std::vector<Cut>& lines, const HalfSpace& inside) {
    std::vector<Cut> result;
    for (Cut line : lines) {
        const auto is_outside = [&](const Vector3d& p) { return inside.depth(p) < 0; };
        const auto first = std::find_if(line.begin(), line.end(), is_outside);
        if (line.front() == line.back() && first != line.end()) {  // to begin outside
            line.pop_back();
            std::rotate(line.begin(), first, line.end());
            line.push_back(line.front());
        }
        for (Cut& run : runs_inside(line.data(), line.size(), inside))
            if (run.size() > 1) result.push_back(std::move(run));
    }
    return result;
}

Cut clip_loop(const Cut& loop, const HalfSpace& inside) {
    Cut result;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const bool is_inside = inside.depth(loop[i]) >= 0;
        if (i > 0 && is_inside != (inside.depth(loop[i - 1]) >= 0))
            result.push_back(crossing(loop[i - 1], loop[i], inside));
        if (is_inside) result.push_back(loop[i]);
    }
    if (!result.empty() && result.front() != result.back()) result.push_back(result.front());
    return result;
}

TriangleMesh clip(const TriangleMesh& mesh, const HalfSpace& inside) {
    TriangleMesh result;
    result.positions = mesh.positions;
    for (const Triangle& t : mesh.triangles) {
        Cut loop;
        int kept = 0;
        bool is_finite = true;
        for (const std::uint32_t v : t) {
            loop.push_back(mesh.positions.at(v));
            kept += inside.depth(loop.back()) >= 0;
            is_finite &= loop.back().allFinite();
        }
        if (!is_finite) continue;
        if (kept == 3) result.triangles.push_back(t);
        if (kept == 0 || kept == 3) continue;
        loop.push_back(loop.front());
        loop = clip_loop(loop, inside);
        const auto first = std::uint32_t(result.positions.size());
        result.positions.insert(result.positions.end(), loop.begin(), loop.end() - 1);
        for (std::uint32_t i = 2; i + 1 < loop.size(); ++i)
            result.triangles.push_back({first, first + i - 1, first + i});
    }
    return result;
}

}  // namespace line_drawing
