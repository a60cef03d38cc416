// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace line_drawing {

/// Which places are inside of lines that lie in or over each other.
enum class FillRule { EvenOdd, NonZero };

/// Lines of straight pieces and cubic Bézier curves in a plane.
struct Path {
    using Point = Eigen::Vector2d;
    enum class Step : unsigned char { Move, Line, Curve };

    struct Piece {
        Step step = Step::Move;
        Point end = Point::Zero();
        Point first = end, second = end;  ///< handles of a curve
    };

    std::vector<Piece> pieces = {};  ///< each line begins with Move
    FillRule fill_rule = FillRule::EvenOdd;

    bool isEmpty() const { return pieces.empty(); }
    void moveTo(const Point& p);
    /// Nothing is added where the line is there already, as in curveTo().
    void lineTo(const Point& p);
    void curveTo(const Point& first, const Point& second, const Point& end);
    /// Straight, to where the line began.
    void close();
    void addRectangle(const Point& corner, double width, double height);
    void addCircle(const Point& center, double radius);

    Path placed(double scale, const Point& shift) const;
    Eigen::AlignedBox2d bounds() const;  ///< exact, also of curves
    /// The points of each line, between which no curve is farther away than `tolerance`.
    std::vector<std::vector<Point>> flattened(double tolerance) const;
};

}  // namespace line_drawing
