// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/drawn_lines.h"

#include <algorithm>
#include <cmath>

namespace line_drawing {
namespace {

using Eigen::Vector2d;

constexpr double least_cosine = 0.94;  // of 20°
constexpr double largest_sine = 0.342;
constexpr double end_share = 0.5;     // of a piece of a line: beyond its end is not beside it
constexpr double piece_share = 0.51;  // of the reach: half a piece, and rounding

Vector2d nearestTo(const Vector2d& begin, const Vector2d& end, const Vector2d& p) {
    const Vector2d way = end - begin;
    return begin + std::clamp(way.dot(p - begin) / way.squaredNorm(), 0., 1.) * way;
}

double distanceTo(const Vector2d& begin, const Vector2d& end, const Vector2d& p) {
    return (nearestTo(begin, end, p) - p).norm();
}

}  // namespace

std::int64_t DrawnLines::squareOf(double coordinate) const {
    return std::int64_t(std::floor(coordinate / reach_));
}

DrawnLines::Cell DrawnLines::cell(std::int64_t x, std::int64_t y) {
    return Cell(std::uint32_t(x)) << 32 | Cell(std::uint32_t(y));
}

void DrawnLines::add(const std::vector<Vector2d>& line, std::size_t number) {
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vector2d way = line[i] - line[i - 1];
        const double steps = std::ceil(way.norm() / reach_);
        for (double s = 0; s < steps; ++s) {  // pieces so short that each is in one square
            const Piece piece = {line[i - 1] + way * (s / steps),
                                 line[i - 1] + way * ((s + 1) / steps), number};
            const Vector2d middle = (piece.begin + piece.end) / 2;
            pieces_[cell(squareOf(middle.x()), squareOf(middle.y()))].push_back(piece);
        }
    }
}

/// By squares that hold the middle of a piece as near as this: pieces are at most `reach` long.
template <class Test>
bool DrawnLines::anyPieceNear(const Vector2d& point, double within, Test test) const {
    const double to_middle = within + piece_share * reach_;
    const auto low = [&](double x) { return squareOf(x - to_middle); };
    const auto high = [&](double x) { return squareOf(x + to_middle); };
    for (std::int64_t x = low(point.x()); x <= high(point.x()); ++x)
        for (std::int64_t y = low(point.y()); y <= high(point.y()); ++y) {
            const auto found = pieces_.find(cell(x, y));
            if (found == pieces_.end()) continue;
            if (std::any_of(found->second.begin(), found->second.end(), test)) return true;
        }
    return false;
}

bool DrawnLines::runAlong(const Vector2d& point, const Vector2d& way, double within) const {
    return anyPieceNear(point, within, [&](const Piece& piece) {
        const Vector2d along = (piece.end - piece.begin).normalized();
        return std::abs(along.dot(way)) >= least_cosine &&
               distanceTo(piece.begin, piece.end, point) < within;
    });
}

bool DrawnLines::isBeside(const Vector2d& point, double within) const {
    return anyPieceNear(point, within, [&](const Piece& piece) {
        const Vector2d way = piece.end - piece.begin;
        const double t = way.dot(point - piece.begin) / way.squaredNorm();
        const bool is_past = t < -end_share || t > 1 + end_share;
        return !is_past && distanceTo(piece.begin, piece.end, point) < within;
    });
}

bool DrawnLines::isNear(const Vector2d& point, const Numbers& except, double within) const {
    return anyPieceNear(point, within, [&](const Piece& piece) {
        return (piece.line < except.first || piece.line > except.last) &&
               distanceTo(piece.begin, piece.end, point) <= within;
    });
}

std::optional<DrawnLines::Place> DrawnLines::nearestOn(const Vector2d& point, const Numbers& except,
                                                       double within) const {
    std::optional<Place> nearest;
    anyPieceNear(point, within, [&](const Piece& piece) {
        if (piece.line >= except.first && piece.line <= except.last) return false;
        const Vector2d place = nearestTo(piece.begin, piece.end, point);
        const double distance = (place - point).norm();
        if (distance > within) return false;
        within = distance;
        nearest = Place{place, piece.line};
        return false;
    });
    return nearest;
}

std::optional<DrawnLines::Neighbour> DrawnLines::nextOn(
    const Vector2d& point, const Vector2d& side, const Distances& distances,
    const std::function<bool(std::size_t)>& skips) const {
    std::optional<Neighbour> nearest;
    double most = distances.most;
    anyPieceNear(point, distances.most, [&](const Piece& piece) {
        const Vector2d across = nearestTo(piece.begin, piece.end, point) - point;
        const Vector2d way = (piece.end - piece.begin).normalized();
        const double distance = across.norm();
        if (distance < distances.least || distance > most ||
            across.dot(side) < least_cosine * distance || std::abs(way.dot(side)) > largest_sine ||
            skips(piece.line))
            return false;
        most = distance;
        nearest = Neighbour{point + across, way, piece.line};
        return false;
    });
    return nearest;
}

DrawnLines allOf(const std::vector<DrawnLine>& lines, double reach) {
    DrawnLines all(reach);
    for (std::size_t i = 0; i < lines.size(); ++i)
        all.add(positionsOf(lines[i]), i);
    return all;
}

}  // namespace line_drawing
