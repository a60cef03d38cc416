// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace line_drawing {

/// As in SVG and PDF.
enum class FillRule { EvenOdd, NonZero };

/// Straight pieces and cubic Bézier curves in a plane.
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

    bool is_empty() const { return pieces.empty(); }
    void move_to(const Point& p);
    /// Adds nothing if the line ends there already, as curve_to() if its handles are there, too.
    void line_to(const Point& p);
    void curve_to(const Point& first, const Point& second, const Point& end);
    void close();  ///< by a straight piece to where the line began
    void add_polygon(const std::vector<Point>& corners);  ///< closed; one corner or more
    void add_rectangle(const Point& corner, double width, double height);
    void add_circle(const Point& center, double radius);

    Path placed(double scale, const Point& shift) const;  ///< scaled, then shifted
    Eigen::AlignedBox2d bounds() const;                   ///< exact, also of curves
    /// Polylines within `tolerance` of the curves, if 512 chords do. What a curve overshoots its
    /// ends along its chord may be left out.
    std::vector<std::vector<Point>> flattened(double tolerance) const;
};

}  // namespace line_drawing
