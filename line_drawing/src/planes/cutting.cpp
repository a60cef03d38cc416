// SPDX-License-Identifier: GPL-3.0-or-later
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
using laplacian_lines::Triangle;
using Place = std::array<double, 3>;

Place placeOf(const Vector3d& p) {
    return {p.x(), p.y(), p.z()};
}

/// The same from both triangles of an edge.
Vector3d crossingOf(Vector3d a, Vector3d b, int axis, double height) {
    if (placeOf(b) < placeOf(a)) std::swap(a, b);
    const double t = (height - a[axis]) / (b[axis] - a[axis]);
    Vector3d crossing = a + t * (b - a);
    crossing[axis] = height;
    return crossing;
}

struct Piece {
    Vector3d begin, end;
    bool used = false;
};

std::vector<Piece> piecesOf(const std::vector<Vector3d>& positions,
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
            // From a side that rises to one that falls: neighbours agree if they face alike.
            (above[next] ? piece.begin : piece.end) = crossingOf(p[k], p[next], axis, height);
            ++found;
        }
        if (found == 2 && piece.begin.allFinite() && piece.end.allFinite() &&
            piece.begin != piece.end)
            pieces.push_back(piece);
    }
    return pieces;
}

using Strip = std::pair<double, double>;

/// Parts of a line that the areas cover together.
std::vector<Strip> stripsAt(const std::vector<Loops>& areas, const Vector2d& direction,
                            double offset) {
    std::vector<Strip> all, joined;
    for (const Loops& loops : areas) {
        const std::vector<double> crossings = crossingsAt(loops, direction, offset);
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

}  // namespace

std::vector<Cut> CuttableMesh::cut(int axis, double height) const {
    std::vector<Piece> pieces = piecesOf(positions_, triangles_, axis, height);
    std::multimap<Place, std::pair<std::size_t, bool>> ends;  // begins before others
    for (const bool is_end : {false, true})
        for (std::size_t i = 0; i < pieces.size(); ++i)
            ends.emplace(placeOf(is_end ? pieces[i].end : pieces[i].begin), std::pair(i, is_end));
    std::vector<Cut> cuts;
    const auto follow = [&](std::size_t i, bool is_backwards) {
        Cut cut = {is_backwards ? pieces[i].end : pieces[i].begin};
        for (bool goes_on = true; goes_on;) {
            pieces[i].used = true;
            cut.push_back(is_backwards ? pieces[i].begin : pieces[i].end);
            const auto [first, last] = ends.equal_range(placeOf(cut.back()));
            const auto on = std::find_if(
                first, last, [&](const auto& end) { return !pieces[end.second.first].used; });
            goes_on = on != last;
            if (goes_on) std::tie(i, is_backwards) = on->second;
        }
        cuts.push_back(std::move(cut));
    };
    const auto is_open = [&](const Vector3d& place) {
        const auto [first, last] = ends.equal_range(placeOf(place));
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

std::vector<double> crossingsAt(const Loops& loops, const Vector2d& direction, double offset) {
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
    double low = 0, high = 0;
    bool any = false;
    for (const Loops& loops : areas)
        for (const auto& loop : loops)
            for (const Vector2d& p : loop) {
                const double at = across.dot(p);
                low = any ? std::min(low, at) : at;
                high = any ? std::max(high, at) : at;
                any = true;
            }
    std::vector<std::vector<Vector2d>> lines;
    for (double at = (std::floor(low / spacing) + 0.5) * spacing; any && at < high; at += spacing) {
        for (const auto& [begin, end] : stripsAt(areas, direction, at))
            lines.push_back({at * across + begin * direction, at * across + end * direction});
    }
    return lines;
}

}  // namespace line_drawing
