// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/drawn_lines.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "options/paper_and_pens.h"
#include "strokes/refining.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

constexpr double kAlongSine = 0.342, kAlongTangent = 0.364;  // of 20°
constexpr double kEndShare = 0.5;     // of a piece of a line: beyond its end is not beside it
constexpr double kPieceShare = 0.51;  // of the reach: half a piece, and rounding

// of for_each_by_families()
constexpr double kFarthestNext = 2;      // times the white: farther ones do not depend on the first
constexpr double kSideBySide = 0.7;      // of the longer one's length
constexpr double kLeastStrength = 0.75;  // of the first

// of is_between_folds()
constexpr double kWidestGap = 4 * kKernelPens;                // pens
constexpr double kUnevenness = 0.25;                          // of a gap's width
constexpr double kLeastBetween = 0.8, kLeastBeyond = 1 / 3.;  // of a line's length

Vector2d nearest_to(const Vector2d& begin, const Vector2d& end, const Vector2d& p) {
    const Vector2d way = end - begin;
    return begin + std::clamp(way.dot(p - begin) / way.squaredNorm(), 0., 1.) * way;
}

double distance_to(const Vector2d& begin, const Vector2d& end, const Vector2d& p) {
    return (nearest_to(begin, end, p) - p).norm();
}

template <class Visit>
void for_each_piece(const DrawnLine& line, double step, Visit visit) {
    const std::vector<Vector2d> points = refine(positions_of(line), step);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vector2d piece = points[i] - points[i - 1];
        visit((points[i] + points[i - 1]) / 2, piece.normalized(), piece.norm());
    }
}

/// Between two lines.
struct Gap {
    double width;
    Vector2d way;    ///< of both on average, unit
    bool has_third;  ///< a line as far beyond one of them
};

std::optional<Gap> gap_at(const Vector2d& point, const Vector2d& way, const DrawnLines& kept,
                          double pen) {
    const Vector2d right = right_of(way), left = -right;
    const DrawnLines::Distances within = {0, kWidestGap * pen};
    const auto on_right = kept.next_on(point, right, within);
    const auto on_left = on_right ? kept.next_on(point, left, within) : std::nullopt;
    if (!on_left) return {};
    const double width = (on_right->position - on_left->position).norm();
    if (width > kWidestGap * pen) return {};
    const auto goes_on = [&](const DrawnLines::Neighbour& line, const Vector2d& side) {
        return kept.next_on(line.position, side,
                            {(1 - kUnevenness) * width, (1 + kUnevenness) * width});
    };
    const double sign = on_right->way.dot(on_left->way) < 0 ? -1 : 1;
    const Vector2d along = (on_right->way + sign * on_left->way).normalized();
    return Gap{width, along.dot(way) < 0 ? Vector2d(-along) : along,
               goes_on(*on_right, right) || goes_on(*on_left, left)};
}

/// How far a gap extends from a place in it, in steps of √h/2 until `most` is reached.
double length_from(Vector2d point, Vector2d way, double width, double most, const DrawnLines& kept,
                   double pen) {
    const double step = kKernelPens * pen / 2;
    double length = 0;
    for (; length < most; length += step) {
        point += step * way;
        const auto gap = gap_at(point, way, kept, pen);
        if (!gap || std::abs(gap->width - width) > kUnevenness * width) break;
        way = gap->way;
    }
    return length;
}

/// The line that is nearest to most of this one, on its right for a `sign` of 1, and not `done`.
std::optional<std::size_t> next_beside(const std::vector<DrawnLine>& lines, std::size_t i,
                                       double sign, const DrawnLines& all, double white,
                                       const std::vector<bool>& done) {
    std::map<std::size_t, double> lengths;
    for_each_piece(lines[i], white,
                   [&](const Vector2d& middle, const Vector2d& way, double length) {
                       const auto next =
                           all.next_on(middle, sign * right_of(way), {white, kFarthestNext * white},
                                       [&](std::size_t line) { return done[line]; });
                       if (next) lengths[next->line] += length;
                   });
    const auto longest = std::max_element(lengths.begin(), lengths.end(),
                                          [](auto& a, auto& b) { return a.second < b.second; });
    if (longest == lengths.end()) return {};
    const double longer =
        std::max(length_of(lines[i].points), length_of(lines[longest->first].points));
    if (longest->second < kSideBySide * longer) return {};
    return longest->first;
}

}  // namespace

bool DrawnLines::Piece::is_passed(const Vector2d& point, double by) const {
    const double length = (end - begin).norm(), at = (end - begin).dot(point - begin) / length;
    return at < -by || at > length + by;
}

std::int64_t DrawnLines::square_of(double coordinate) const {
    return std::int64_t(std::floor(coordinate / reach_));
}

DrawnLines::Cell DrawnLines::cell(std::int64_t x, std::int64_t y) {
    return Cell(std::uint32_t(x)) << 32 | Cell(std::uint32_t(y));
}

void DrawnLines::add(const std::vector<Vector2d>& line, std::size_t number) {
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vector2d way = line[i] - line[i - 1];
        const double steps = std::ceil(way.norm() / reach_);
        for (double s = 0; s < steps; ++s) {  // so short that the squares around find them
            const Piece piece = {line[i - 1] + way * (s / steps),
                                 line[i - 1] + way * ((s + 1) / steps), number};
            const Vector2d middle = (piece.begin + piece.end) / 2;
            pieces_[cell(square_of(middle.x()), square_of(middle.y()))].push_back(piece);
        }
    }
}

/// By squares that may hold the middle of such a piece: pieces are at most `reach` long.
template <class Test>
bool DrawnLines::any_piece_in(const Eigen::AlignedBox2d& box, Test test) const {
    if (pieces_.empty()) return false;
    const double to_middle = kPieceShare * reach_;
    const auto low = [&](double x) { return square_of(x - to_middle); };
    const auto high = [&](double x) { return square_of(x + to_middle); };
    for (std::int64_t x = low(box.min().x()); x <= high(box.max().x()); ++x)
        for (std::int64_t y = low(box.min().y()); y <= high(box.max().y()); ++y) {
            const auto found = pieces_.find(cell(x, y));
            if (found == pieces_.end()) continue;
            if (std::any_of(found->second.begin(), found->second.end(), test)) return true;
        }
    return false;
}

template <class Test>
bool DrawnLines::any_piece_near(const Vector2d& point, double within, Test test) const {
    const Vector2d room = Vector2d::Constant(within);
    return any_piece_in(Eigen::AlignedBox2d(point - room, point + room), test);
}

bool DrawnLines::run_along(const Vector2d& point, const Vector2d& way, double within,
                           double beyond) const {
    return any_piece_near(point, within, [&](const Piece& piece) {
        const Vector2d along = (piece.end - piece.begin).normalized();
        return std::abs(along.dot(way)) >= kAlongCosine && !piece.is_passed(point, beyond) &&
               distance_to(piece.begin, piece.end, point) < within;
    });
}

bool DrawnLines::is_beside(const Vector2d& point, double within) const {
    return any_piece_near(point, within, [&](const Piece& piece) {
        const double by = kEndShare * (piece.end - piece.begin).norm();
        return !piece.is_passed(point, by) && distance_to(piece.begin, piece.end, point) < within;
    });
}

bool DrawnLines::is_near(const Vector2d& point, std::size_t except, double within) const {
    return any_piece_near(point, within, [&](const Piece& piece) {
        return piece.line != except && distance_to(piece.begin, piece.end, point) <= within;
    });
}

std::optional<DrawnLines::Place> DrawnLines::nearest_on(const Vector2d& point, std::size_t except,
                                                        double within) const {
    std::optional<Place> nearest;
    any_piece_near(point, within, [&](const Piece& piece) {
        if (piece.line == except) return false;
        const Vector2d place = nearest_to(piece.begin, piece.end, point);
        const double distance = (place - point).norm();
        if (distance > within) return false;
        within = distance;
        nearest = Place{place, piece.line};
        return false;
    });
    return nearest;
}

std::optional<DrawnLines::Neighbour> DrawnLines::next_on(
    const Vector2d& point, const Vector2d& side, const Distances& distances,
    const std::function<bool(std::size_t)>& skips) const {
    std::optional<Neighbour> nearest;
    double most = distances.most;
    const Vector2d farthest = point + most * side, aside = most * kAlongTangent * right_of(side);
    Eigen::AlignedBox2d box(point);
    box.extend(farthest + aside).extend(farthest - aside);
    any_piece_in(box, [&](const Piece& piece) {
        const Vector2d across = nearest_to(piece.begin, piece.end, point) - point;
        const double distance = across.norm();
        if (distance < distances.least || distance > most ||
            across.dot(side) < kAlongCosine * distance)
            return false;
        const Vector2d way = (piece.end - piece.begin).normalized();
        if (std::abs(way.dot(side)) > kAlongSine || skips(piece.line)) return false;
        most = distance;
        nearest = Neighbour{point + across, way, piece.line};
        return false;
    });
    return nearest;
}

bool is_curved_contour(const DrawnLine& line) {
    return line.line_class == LineClass::Contour && is_smooth(line);
}

bool is_on_curved(const DrawnLine& line) {
    return is_inner(line) || is_curved_contour(line);
}

DrawnLines all_of(const std::vector<DrawnLine>& lines, double reach) {
    DrawnLines all(reach);
    for (std::size_t i = 0; i < lines.size(); ++i)
        all.add(positions_of(lines[i]), i);
    return all;
}

double share_between(const DrawnLine& line, std::size_t number, const DrawnLines& lines,
                     double within) {
    double length = 0, between = 0;
    for_each_piece(line, within, [&](const Vector2d& middle, const Vector2d& way, double piece) {
        const auto has_next = [&](const Vector2d& side) {
            return lines
                .next_on(middle, side, {0, within}, [&](std::size_t i) { return i == number; })
                .has_value();
        };
        length += piece;
        if (has_next(right_of(way)) && has_next(-right_of(way))) between += piece;
    });
    return between / length;
}

void for_each_by_families(const std::vector<DrawnLine>& lines, const std::vector<double>& strengths,
                          double white, const std::function<bool(std::size_t)>& keep) {
    const DrawnLines all = all_of(lines, kFarthestNext * white);
    std::vector<bool> done(lines.size(), false);
    for (std::size_t first = 0; first < lines.size(); ++first)
        for (std::vector<std::size_t> next = {first}; !next.empty();) {
            const std::size_t i = next.back();
            next.pop_back();
            if (done[i]) continue;
            done[i] = true;
            if (!keep(i)) continue;
            for (const double sign : {-1., 1.}) {
                const auto beside = next_beside(lines, i, sign, all, white, done);
                if (beside && strengths[*beside] >= kLeastStrength * strengths[first])
                    next.push_back(*beside);
            }
        }
}

bool is_between_folds(const DrawnLine& line, const DrawnLines& kept, double pen) {
    if (line.closed || line.points.size() < 2) return false;
    double length = 0, between = 0, third = 0, width = 0;
    for_each_piece(line, kKernelPens * pen,
                   [&](const Vector2d& middle, const Vector2d& way, double piece) {
                       length += piece;
                       const auto gap = gap_at(middle, way, kept, pen);
                       if (!gap) return;
                       between += piece;
                       width += piece * gap->width;
                       if (gap->has_third) third += piece;
                   });
    if (between < kLeastBetween * length || third < between / 2) return false;
    double beyond = 0;
    for (const bool is_last : {false, true})
        beyond += length_from((is_last ? line.points.back() : line.points.front()).position,
                              outwards_at(line.points, is_last, kKernelPens * pen), width / between,
                              length, kept, pen);
    return beyond > kLeastBeyond * length;
}

}  // namespace line_drawing
