// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts by planes. Each triangle that a plane crosses gives a piece, whose ends have the same bits
// from both triangles of an edge; pieces are joined where ends are equal, open lines first. Lines,
// loops and meshes are clipped to one side of a plane, and walls hatched by lines across them.
#include "planes/cutting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <tuple>

namespace line_drawing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using laplacian_lines::LinePoint;
using laplacian_lines::LineSet;
using laplacian_lines::Polyline;
using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;
using laplacian_lines::ViewLine;
using laplacian_lines::ViewLinePoint;
using Place = std::array<double, 3>;

Place place_of(const Vector3d& p) {
    return {p.x(), p.y(), p.z()};
}

/// Bit-identical from both triangles of an edge.
Vector3d crossing_of(Vector3d a, Vector3d b, int axis, double height) {
    if (place_of(b) < place_of(a)) std::swap(a, b);
    const double t = (height - a[axis]) / (b[axis] - a[axis]);
    Vector3d crossing = a + t * (b - a);
    crossing[axis] = height;
    return crossing;
}

struct Piece {
    Vector3d begin, end;
    bool used = false;
};

std::vector<Piece> pieces_of(const std::vector<Vector3d>& positions,
                             const std::vector<Triangle>& triangles, int axis, double height) {
    std::vector<Piece> pieces;
    for (const Triangle& t : triangles) {
        std::array<Vector3d, 3> p;
        std::array<bool, 3> above{};
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = positions.at(t[k]);
            above[k] = p[k][axis] >= height;
        }
        Piece piece;
        int found = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            if (above[k] == above[next]) continue;
            // From a rising side to a falling one: consistent between triangles of equal
            // orientation.
            (above[next] ? piece.begin : piece.end) = crossing_of(p[k], p[next], axis, height);
            ++found;
        }
        if (found == 2 && piece.begin.allFinite() && piece.end.allFinite() &&
            piece.begin != piece.end)
            pieces.push_back(piece);
    }
    return pieces;
}

using Strip = std::pair<double, double>;

/// The parts of a line within the union of the areas.
std::vector<Strip> strips_at(const std::vector<Loops>& areas, const Vector2d& direction,
                             double offset) {
    std::vector<Strip> all, joined;
    for (const Loops& loops : areas) {
        const std::vector<double> crossings = crossings_at(loops, direction, offset);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
            all.emplace_back(crossings[i], crossings[i + 1]);
    }
    std::sort(all.begin(), all.end());
    for (const Strip& strip : all)
        if (joined.empty() || strip.first > joined.back().second)
            joined.push_back(strip);
        else
            joined.back().second = std::max(joined.back().second, strip.second);
    return joined;
}

Vector3d position_of(const LinePoint& p) {
    return p.position.cast<double>();
}
const Vector3d& position_of(const Vector3d& p) {
    return p;
}
LinePoint between(const LinePoint& a, const LinePoint& b, double t) {
    const auto mix = [t](float x, float y) { return float((1 - t) * double(x) + t * double(y)); };
    return {((1 - t) * position_of(a) + t * position_of(b)).cast<float>(), mix(a.weight, b.weight),
            mix(a.gradient, b.gradient), mix(a.opacity, b.opacity)};
}
Vector3d between(const Vector3d& a, const Vector3d& b, double t) {
    return (1 - t) * a + t * b;
}
const Vector3d& position_of(const ViewLinePoint& p) {
    return p.position;
}
ViewLinePoint between(const ViewLinePoint& a, const ViewLinePoint& b, double t) {
    const auto mix = [t](float x, float y) { return float((1 - t) * double(x) + t * double(y)); };
    return {between(a.position, b.position, t), mix(a.weight, b.weight),
            mix(a.gradient, b.gradient),        mix(a.opacity, b.opacity),
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

}  // namespace

std::vector<Cut> CuttableMesh::cut(int axis, double height) const {
    std::vector<Piece> pieces = pieces_of(positions_, triangles_, axis, height);
    std::multimap<Place, std::pair<std::size_t, bool>> ends;  // begins before others
    for (const bool is_end : {false, true})
        for (std::size_t i = 0; i < pieces.size(); ++i)
            ends.emplace(place_of(is_end ? pieces[i].end : pieces[i].begin), std::pair(i, is_end));
    std::vector<Cut> cuts;
    const auto follow = [&](std::size_t i, bool is_backwards) {
        Cut cut = {is_backwards ? pieces[i].end : pieces[i].begin};
        for (bool goes_on = true; goes_on;) {
            pieces[i].used = true;
            cut.push_back(is_backwards ? pieces[i].begin : pieces[i].end);
            const auto [first, last] = ends.equal_range(place_of(cut.back()));
            const auto on = std::find_if(
                first, last, [&](const auto& end) { return !pieces[end.second.first].used; });
            goes_on = on != last;
            if (goes_on) std::tie(i, is_backwards) = on->second;
        }
        cuts.push_back(std::move(cut));
    };
    const auto is_open = [&](const Vector3d& place) {
        const auto [first, last] = ends.equal_range(place_of(place));
        return std::distance(first, last) % 2 == 1 &&
               first->second.second == std::prev(last)->second.second;  // all begin or all end
    };
    // Open lines first, from their ends.
    for (const bool is_end : {false, true})
        for (std::size_t i = 0; i < pieces.size(); ++i)
            if (!pieces[i].used && is_open(is_end ? pieces[i].end : pieces[i].begin))
                follow(i, is_end);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (!pieces[i].used) follow(i, false);
    return cuts;
}

std::vector<double> crossings_at(const Loops& loops, const Vector2d& direction, double offset) {
    const Vector2d across(-direction.y(), direction.x());
    std::vector<double> crossings;
    for (const auto& loop : loops)
        for (std::size_t i = 1; i < loop.size(); ++i) {
            const double a = across.dot(loop[i - 1]) - offset, b = across.dot(loop[i]) - offset;
            if ((a < 0) == (b < 0)) continue;
            crossings.push_back(
                direction.dot(loop[i - 1] + (loop[i] - loop[i - 1]) * (a / (a - b))));
        }
    std::sort(crossings.begin(), crossings.end());
    return crossings;
}

std::vector<std::vector<Vector2d>> hatch(const std::vector<Loops>& areas, const Vector2d& direction,
                                         double spacing) {
    const Vector2d across(-direction.y(), direction.x());
    double low = INFINITY, high = -INFINITY;
    for (const Loops& loops : areas)
        for (const auto& loop : loops)
            for (const Vector2d& p : loop) {
                low = std::min(low, across.dot(p));
                high = std::max(high, across.dot(p));
            }
    std::vector<std::vector<Vector2d>> lines;
    for (double at = (std::floor(low / spacing) + 0.5) * spacing; at < high; at += spacing) {
        for (const auto& [begin, end] : strips_at(areas, direction, at))
            lines.push_back({at * across + begin * direction, at * across + end * direction});
    }
    return lines;
}

LineSet clip(const LineSet& lines, const HalfSpace& inside) {
    LineSet result;
    for (const Polyline& line : lines.lines)
        for (const auto& run : runs_inside(lines.points.data() + line.first, line.count, inside)) {
            if (run.size() < 2) continue;
            Polyline part = line;
            part.first = std::uint32_t(result.points.size());
            part.count = std::uint32_t(run.size());
            part.closed = line.closed && part.count == line.count;
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
            part.closed = line.closed && run.size() == line.points.size();
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
