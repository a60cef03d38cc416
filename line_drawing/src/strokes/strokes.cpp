// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/strokes.h"

#include <algorithm>
#include <cmath>

#include "strokes/curve_fitting.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

constexpr double thinnest_stroke = 0.06;  // mm; where it is less a line is drawn so thin
constexpr double thinnest_middle = 0.04;  // mm; lines that are nowhere wider are left out

constexpr double least_round_width = 0.1;  // mm; ends of thinner strokes are cut off
constexpr double half_turn = 3.141592653589793;

// mm; as ISO 128 has it for this pen, nearly
constexpr double dash = 2, shortest_dashed_line = 3 * dash;

struct Spine {
    Points points;               // on the sheet
    std::vector<double> widths;  // mm, of the stroke
    double length = 0;
};

Spine spineOf(const DrawnLine& line, double pen) {
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

/// Unit, to the right of the direction on a sheet whose y points down.
Points normalsOf(const Points& points, bool closed) {
    const std::size_t n = points.size();
    Points normals(n);
    for (std::size_t i = 0; i < n; ++i) {
        const bool is_first = i == 0, is_last = i + 1 == n;
        const Vector2d& before = is_first ? points[closed ? n - 2 : 0] : points[i - 1];
        const Vector2d& after = is_last ? points[closed ? 1 : n - 1] : points[i + 1];
        const Vector2d way = (after - before).stableNormalized();
        normals[i] = {-way.y(), way.x()};
    }
    return normals;
}

Points offset(const Spine& spine, const Points& normals, double sign) {
    Points edge;
    for (std::size_t i = 0; i < spine.points.size(); ++i)
        edge.push_back(spine.points[i] +
                       sign / 2 * std::max(spine.widths[i], thinnest_stroke) * normals[i]);
    return edge;
}

/// A half circle from the right to the left of a stroke's end.
void addCap(const Vector2d& end, const Vector2d& normal, double width, double direction,
            Points& outline) {
    constexpr int points = 8;
    if (width < least_round_width) return;
    const Vector2d way = direction * Vector2d(normal.y(), -normal.x());
    for (int i = 1; i < points; ++i) {
        const double angle = half_turn * i / points;
        outline.push_back(end + width / 2 *
                                    (direction * std::cos(angle) * normal + std::sin(angle) * way));
    }
}

Path taperedStroke(const Spine& spine, bool closed, double tolerance) {
    const Points normals = normalsOf(spine.points, closed);
    Points right = offset(spine, normals, 1), left = offset(spine, normals, -1);
    std::reverse(left.begin(), left.end());
    Path path;
    path.fill_rule = FillRule::NonZero;
    if (closed) {  // a ring: its edges run in opposite directions
        fitCurve(right, true, tolerance, path);
        fitCurve(left, true, tolerance, path);
    } else {
        addCap(spine.points.back(), normals.back(), spine.widths.back(), 1, right);
        right.insert(right.end(), left.begin(), left.end());
        addCap(spine.points.front(), normals.front(), spine.widths.front(), -1, right);
        right.push_back(right.front());
        fitCurve(right, true, tolerance, path);
    }
    return path;
}

}  // namespace

std::optional<SheetPath> drawStroke(const DrawnLine& line, const SheetOptions& options) {
    const double pen = options.pens[std::size_t(line.line_class)];
    const bool is_hidden = line.line_class == LineClass::Hidden;
    const bool is_tapered = options.strokes == StrokeStyle::Tapered && !is_hidden;
    // A faint line tapers from the width of a clear one.
    const double full = line.line_class == LineClass::Fine && is_tapered
                            ? options.pens[std::size_t(LineClass::Inner)]
                            : pen;
    const Spine spine = spineOf(line, full);
    if (spine.points.size() < 2) return {};
    if (is_hidden && spine.length < shortest_dashed_line) return {};
    if (*std::max_element(spine.widths.begin(), spine.widths.end()) < thinnest_middle) return {};
    const bool closed = line.closed && spine.points.size() > 3;
    SheetPath result;
    if (is_tapered) {
        result.path = taperedStroke(spine, closed, options.tolerance);
    } else {
        result.pen_width = pen;
        if (is_hidden) result.dash = dash;
        fitCurve(spine.points, closed, options.tolerance, result.path);
    }
    return result;
}

}  // namespace line_drawing
