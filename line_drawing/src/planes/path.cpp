// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/path.h"

#include <algorithm>
#include <cmath>

namespace line_drawing {
namespace {

using Point = Path::Point;

constexpr double kRounding = 1e-12;              // of a coordinate, mm or font heights
constexpr double kQuarterHandle = 0.5522847498;  // handle of a quarter of the unit circle
constexpr int kMostHalvings = 9;                 // a curve is then 512 chords, whatever its size

/// Whether the distances of both handles from the line through begin and end add up to less than
/// `tolerance`, on slanted lines up to √2 times that: the curve is at most 4/9 of the sum away.
/// Where begin and end are within two tolerances, the distances are those from begin, |x| + |y|.
bool is_flat(const Point& begin, const Path::Piece& curve, double tolerance) {
    const Point span = curve.end - begin, first = begin - curve.first,
                second = begin - curve.second;
    const double length = span.lpNorm<1>();
    if (length <= 2 * tolerance) return first.lpNorm<1>() + second.lpNorm<1>() < tolerance;
    const auto across = [&](const Point& p) {
        return std::abs(span.x() * p.y() - span.y() * p.x());
    };
    return across(first) + across(second) < tolerance * length;
}

void flatten(const Point& begin, const Path::Piece& curve, double tolerance, int halvings,
             std::vector<Point>& points) {
    if (halvings == 0 || is_flat(begin, curve, tolerance)) return points.push_back(curve.end);
    const Point a = (begin + curve.first) / 2, b = (curve.first + curve.second) / 2,
                c = (curve.second + curve.end) / 2, ab = (a + b) / 2, bc = (b + c) / 2,
                middle = (ab + bc) / 2;
    flatten(begin, {Path::Step::Curve, middle, a, ab}, tolerance, halvings - 1, points);
    flatten(middle, {Path::Step::Curve, curve.end, bc, c}, tolerance, halvings - 1, points);
}

double coordinate_at(double t, double a, double b, double c, double d) {
    const double s = 1 - t;
    return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
}

/// Extends a range to the extrema of a coordinate of a curve, where its derivative, 3 (square t² +
/// 2 half t + rest), is 0. Of the two roots neither is a difference of nearly equal numbers.
void extend_to_turns(const Point& begin, const Path::Piece& curve, int axis,
                     Eigen::AlignedBox2d& box) {
    const double a = begin[axis], b = curve.first[axis], c = curve.second[axis],
                 d = curve.end[axis];
    const double square = d - 3 * c + 3 * b - a, half = c - 2 * b + a, rest = b - a;
    const double root = std::sqrt(std::max(0., half * half - square * rest));
    const double sum = -half - std::copysign(root, half);
    for (const double t : {sum / square, rest / sum})
        if (t > 0 && t < 1) {
            const double turn = coordinate_at(t, a, b, c, d);
            box.min()[axis] = std::min(box.min()[axis], turn);
            box.max()[axis] = std::max(box.max()[axis], turn);
        }
}

}  // namespace

void Path::move_to(const Point& p) {
    if (!pieces.empty() && pieces.back().step == Step::Move) pieces.pop_back();
    pieces.push_back({Step::Move, p});
}

void Path::line_to(const Point& p) {
    const bool is_there = (pieces.back().end - p).lpNorm<Eigen::Infinity>() <= kRounding;
    if (!is_there) pieces.push_back({Step::Line, p});
}

void Path::curve_to(const Point& first, const Point& second, const Point& end) {
    const Point& begin = pieces.back().end;
    if (begin != first || first != second || second != end)
        pieces.push_back({Step::Curve, end, first, second});
}

void Path::close() {
    auto begin = pieces.rbegin();
    while (begin->step != Step::Move)
        ++begin;
    line_to(Point(begin->end));
}

void Path::add_polygon(const std::vector<Point>& corners) {
    move_to(corners[0]);
    for (const Point& corner : corners)
        line_to(corner);
    close();
}

void Path::add_rectangle(const Point& corner, double width, double height) {
    add_polygon({corner, corner + Point(width, 0), corner + Point(width, height),
                 corner + Point(0, height)});
}

void Path::add_circle(const Point& center, double radius) {
    Point out(radius, 0);
    move_to(center + out);
    for (int quarter = 0; quarter < 4; ++quarter) {
        const Point next(-out.y(), out.x());
        curve_to(center + out + kQuarterHandle * next, center + next + kQuarterHandle * out,
                 center + next);
        out = next;
    }
}

Path Path::placed(double scale, const Point& shift) const {
    Path path = *this;
    for (Piece& piece : path.pieces)
        for (Point* p : {&piece.end, &piece.first, &piece.second})
            *p = scale * *p + shift;
    return path;
}

Eigen::AlignedBox2d Path::bounds() const {
    Eigen::AlignedBox2d box;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        box.extend(pieces[i].end);
        if (pieces[i].step == Step::Curve)
            for (const int axis : {0, 1})
                extend_to_turns(pieces[i - 1].end, pieces[i], axis, box);
    }
    return box;
}

std::vector<std::vector<Point>> Path::flattened(double tolerance) const {
    std::vector<std::vector<Point>> lines;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].step == Step::Move)
            lines.push_back({pieces[i].end});
        else if (pieces[i].step == Step::Line)
            lines.back().push_back(pieces[i].end);
        else
            flatten(pieces[i - 1].end, pieces[i], tolerance, kMostHalvings, lines.back());
    }
    return lines;
}

}  // namespace line_drawing
