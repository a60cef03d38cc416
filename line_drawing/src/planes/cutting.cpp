// SPDX-License-Identifier: GPL-3.0-or-later
// Each triangle that a plane crosses gives a piece, whose ends have the same bits from both
// triangles of an edge. Pieces are joined where their ends are equal: open lines first, from their
// ends, then closed ones from any piece.
#include "planes/cutting.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace line_drawing {
namespace {

using Eigen::Vector3d;
using laplacian_lines::Triangle;
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

/// Joins pieces whose ends are at the same place.
class PieceJoiner {
public:
    explicit PieceJoiner(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
        for (const bool is_end : {false, true})
            for (std::size_t i = 0; i < pieces_.size(); ++i)
                ends_.emplace(place_of(is_end ? pieces_[i].end : pieces_[i].begin),
                              std::pair(i, is_end));
    }

    std::vector<Cut> join() {
        std::vector<Cut> cuts;
        for (const bool is_end : {false, true})
            for (std::size_t i = 0; i < pieces_.size(); ++i)
                if (!pieces_[i].used && is_open(is_end ? pieces_[i].end : pieces_[i].begin))
                    cuts.push_back(follow(i, is_end));
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            if (!pieces_[i].used) cuts.push_back(follow(i, false));
        return cuts;
    }

private:
    /// Whether a line ends there: an odd number of pieces meet, all with their begin or their end.
    bool is_open(const Vector3d& place) const {
        const auto [first, last] = ends_.equal_range(place_of(place));
        return std::distance(first, last) % 2 == 1 &&
               first->second.second == std::prev(last)->second.second;
    }

    /// The line from a piece on, along pieces that are not used.
    Cut follow(std::size_t i, bool is_backwards) {
        Cut cut = {is_backwards ? pieces_[i].end : pieces_[i].begin};
        for (bool goes_on = true; goes_on;) {
            pieces_[i].used = true;
            cut.push_back(is_backwards ? pieces_[i].begin : pieces_[i].end);
            const auto [first, last] = ends_.equal_range(place_of(cut.back()));
            const auto on = std::find_if(
                first, last, [&](const auto& end) { return !pieces_[end.second.first].used; });
            goes_on = on != last;
            if (goes_on) std::tie(i, is_backwards) = on->second;
        }
        return cut;
    }

    std::vector<Piece> pieces_;
    std::multimap<Place, std::pair<std::size_t, bool>> ends_;  // at a place, begins come first
};

}  // namespace

std::vector<Cut> CuttableMesh::cut(int axis, double height) const {
    return PieceJoiner(pieces_of(positions_, triangles_, axis, height)).join();
}

}  // namespace line_drawing
