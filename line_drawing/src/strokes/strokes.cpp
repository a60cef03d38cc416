// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/strokes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "strokes/drawn_lines.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

constexpr double kTolerance = 0.02;       // mm; of curves against the lines
constexpr double kThinnestStroke = 0.06;  // mm; thinner parts are drawn as wide as this

constexpr double kLargestUnevenness = 0.01;  // share of the width that nobody sees
constexpr double kCosineOfJoin = 0.9;        // of 26°; smaller turns are mitred, larger ones round
constexpr double kJoinStep = 0.4;            // radians between the points of a round join
constexpr double kCoveredShare = 0.9;        // of the radius: edges of tapers are near wider places
constexpr double kLeastRoundWidth = 0.1;     // mm; ends of thinner strokes are cut off
constexpr double kPi = EIGEN_PI;

// mm; of the pen of hidden lines ISO 128 has 12 widths, 2.2 mm
constexpr double kDash = 2, kShortestDashedLine = 3 * kDash;

struct Spine {
    Points points;               // on the sheet
    std::vector<double> widths;  // mm, of the stroke
    double length = 0;
};

Spine spine_of(const DrawnLine& line, double pen) {
    Spine spine;
    for (const DrawnPoint& point : line.points) {
        const Vector2d& p = point.position;
        if (!spine.points.empty()) {
            const double step = (p - spine.points.back()).norm();
            if (step == 0) continue;
            spine.length += step;
        }
        spine.points.push_back(p);
        spine.widths.push_back(pen * point.weight);
    }
    return spine;
}

/// The two edges of a stroke: offset curves of its spine, joined round where it turns.
class StrokeEdges {
public:
    StrokeEdges(const Spine& spine, bool closed) : spine_(spine), closed_(closed) {
        for (std::size_t i = 1; i < spine.points.size(); ++i)
            ways_.push_back((spine.points[i] - spine.points[i - 1]).normalized());
    }

    /// Unit, of the first and the last piece.
    const Vector2d& first_way() const { return ways_.front(); }
    const Vector2d& last_way() const { return ways_.back(); }

    /// `side`: 1 for the right edge, -1 for the left one. That of a closed line ends as it begins.
    Points edge(int side) const {
        Points edge;
        const std::size_t pieces = ways_.size();
        for (std::size_t i = 0; i < pieces + (closed_ ? 0 : 1); ++i) {
            const std::size_t before = i > 0 ? i - 1 : closed_ ? pieces - 1 : 0;
            join(i, side, ways_[before], ways_[std::min(i, pieces - 1)], edge);
        }
        if (closed_ && !edge.empty()) edge.push_back(edge.front());
        return edge;
    }

private:
    double radius_at(std::size_t i) const {
        return std::max(spine_.widths[i], kThinnestStroke) / 2;
    }

    void join(std::size_t i, int side, const Vector2d& before, const Vector2d& after,
              Points& edge) const {
        const Vector2d from = side * radius_at(i) * right_of(before),
                       to = side * radius_at(i) * right_of(after);
        const double cosine = std::clamp(before.dot(after), -1., 1.);
        if (cosine > kCosineOfJoin) return add(i, (from + to) / (1 + cosine), edge);
        const double turn = std::atan2(before.x() * after.y() - before.y() * after.x(), cosine);
        if (side * turn > 0) {  // the inner side
            add(i, from, edge);
            return add(i, to, edge);
        }
        const double steps = std::ceil(std::abs(turn) / kJoinStep);
        for (double k = 0; k <= steps; ++k)
            edge.push_back(spine_.points[i] + Eigen::Rotation2Dd(turn * k / steps) * from);
    }

    /// On the inner side of a tight turn the stroke covers its own edge, which would be a knot.
    void add(std::size_t i, const Vector2d& offset, Points& edge) const {
        const Vector2d place = spine_.points[i] + offset;
        if (!is_covered(i, place, 1) && !is_covered(i, place, -1)) edge.push_back(place);
    }

    /// Whether the stroke covers a place by the pieces after (`step` 1) or before (-1) point i,
    /// over one width along the line.
    bool is_covered(std::size_t i, const Vector2d& place, int step) const {
        const auto count = std::ptrdiff_t(ways_.size());
        std::ptrdiff_t piece = std::ptrdiff_t(i) - (step < 0);
        double length = 0;
        for (std::ptrdiff_t k = 0; k < count && length < 2 * radius_at(i); ++k, piece += step) {
            if (closed_) piece = (piece + count) % count;
            if (piece < 0 || piece >= count) break;
            const auto first = std::size_t(piece);
            const Vector2d way = spine_.points[first + 1] - spine_.points[first];
            const Vector2d from_first = place - spine_.points[first];
            const double t = std::clamp(way.dot(from_first) / way.squaredNorm(), 0., 1.);
            const double radius = (1 - t) * radius_at(first) + t * radius_at(first + 1);
            if ((from_first - t * way).norm() < kCoveredShare * radius) return true;
            length += way.norm();
        }
        return false;
    }

    const Spine& spine_;
    const bool closed_;
    Points ways_;
};

/// A half circle from the right to the left of a stroke's end; `way`: out of the stroke.
void add_cap(const Vector2d& end, const Vector2d& way, double width, Points& outline) {
    constexpr int points = 8;
    if (width < kLeastRoundWidth) return;
    for (int i = 1; i < points; ++i)
        outline.push_back(end +
                          Eigen::Rotation2Dd(-kPi * i / points) * (width / 2 * right_of(way)));
}

Path tapered_stroke(const Spine& spine, bool closed) {
    const StrokeEdges edges(spine, closed);
    Points right = edges.edge(1), left = edges.edge(-1);
    std::reverse(left.begin(), left.end());
    Path path;
    path.fill_rule = FillRule::NonZero;
    if (closed) {  // a ring: its edges run in opposite directions
        fit_curve(right, true, kTolerance, path);
        fit_curve(left, true, kTolerance, path);
    } else {
        add_cap(spine.points.back(), edges.last_way(), spine.widths.back(), right);
        right.insert(right.end(), left.begin(), left.end());
        add_cap(spine.points.front(), -edges.first_way(), spine.widths.front(), right);
        right.push_back(right.front());
        fit_curve(right, true, kTolerance, path);
    }
    return path;
}

/// Whether a stroke has one width: then it is a line with a pen, which any program can draw.
bool is_even(const Spine& spine) {
    const auto [least, most] = std::minmax_element(spine.widths.begin(), spine.widths.end());
    return *most - *least < kLargestUnevenness * *most;
}

}  // namespace

std::optional<SheetPath> draw_stroke(const DrawnLine& line, const SheetOptions& options) {
    const double pen = options.pens[std::size_t(line.line_class)];
    const bool is_hidden = line.line_class == LineClass::Hidden;
    const bool is_tapered = options.strokes == StrokeStyle::Tapered && !is_hidden;
    // A faint line tapers from the width of a clear one.
    const double full = line.line_class == LineClass::Fine && is_tapered
                            ? options.pens[std::size_t(LineClass::Inner)]
                            : pen;
    const Spine spine = spine_of(line, full);
    if (spine.points.size() < 2) return {};
    if (is_hidden && spine.length < kShortestDashedLine) return {};
    const bool closed = line.closed && spine.points.size() > 3;
    SheetPath result;
    if (is_tapered && !is_even(spine)) {
        result.path = tapered_stroke(spine, closed);
    } else {
        result.pen_width = is_tapered ? std::max(spine.widths[0], kThinnestStroke) : pen;
        if (is_hidden) result.dash = kDash;
        fit_curve(spine.points, closed, kTolerance, result.path);
    }
    return result;
}

}  // namespace line_drawing
