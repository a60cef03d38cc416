// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainterPath>
#include <QPolygonF>
#include <QRectF>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "generators.h"
#include "laplacian_lines/precompute.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/words.h"

namespace sheet_helpers {

/// Qt's path, which measures independently.
inline QPainterPath painter_path(const line_drawing::Path& path) {
    using Step = line_drawing::Path::Step;
    const auto in_qt = [](const Eigen::Vector2d& p) { return QPointF(p.x(), p.y()); };
    QPainterPath result;
    for (const auto& piece : path.pieces)
        if (piece.step == Step::Move)
            result.moveTo(in_qt(piece.end));
        else if (piece.step == Step::Line)
            result.lineTo(in_qt(piece.end));
        else
            result.cubicTo(in_qt(piece.first), in_qt(piece.second), in_qt(piece.end));
    const bool is_even_odd = path.fill_rule == line_drawing::FillRule::EvenOdd;
    result.setFillRule(is_even_odd ? Qt::OddEvenFill : Qt::WindingFill);
    return result;
}

inline QRectF paper_of(const Eigen::Vector2d& size) {
    return {0, 0, size.x(), size.y()};
}

/// From -50 to 50 along each axis.
inline laplacian_lines::TriangleMesh cube_of100() {
    return test_meshes::moved(test_meshes::cube(4), {0, 0, 0}, 50);
}

inline line_drawing::Sheet sheet_of(const laplacian_lines::TriangleMesh& mesh,
                                    const line_drawing::SheetOptions& options) {
    const laplacian_lines::Field field = laplacian_lines::precompute(mesh);
    return line_drawing::make_sheets({{mesh, &field}}, {options}).front();
}

/// Views with z up, at 1:1; none if the text is empty.
inline line_drawing::SheetOptions plain_views(const char* views, const char* paper = "a0") {
    line_drawing::SheetOptions options;
    if (*views) options.views = line_drawing::parse_views(views, line_drawing::UpAxis::Z);
    options.strokes = line_drawing::StrokeStyle::Plain;
    options.paper = paper;
    options.scale = 1;
    return options;
}

inline line_drawing::SheetOptions with_sections(const char* views, const char* sections) {
    line_drawing::SheetOptions options = plain_views(views);
    options.sections = line_drawing::parse_sections(sections);
    options.up = line_drawing::UpAxis::Z;
    return options;
}

inline const line_drawing::SheetLayer& layer_of(const line_drawing::SheetGroup& group,
                                                const char* key) {
    for (const line_drawing::SheetLayer& layer : group.layers)
        if (layer.key == key) return layer;
    throw std::out_of_range(key);
}

inline double length_of(const line_drawing::SheetLayer& layer) {
    double length = 0;
    for (const line_drawing::SheetPath& path : layer.paths)
        length += painter_path(path.path).length();
    return length;
}

/// From a polyline; infinite if it has fewer than two points.
inline double distance_to(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& p) {
    double least = INFINITY;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Eigen::Vector2d &a = line[i - 1], span = line[i] - a;
        const double squared = span.squaredNorm();
        const double t = squared > 0 ? std::clamp(span.dot(p - a) / squared, 0., 1.) : 0;
        least = std::min(least, (a + t * span - p).norm());
    }
    return least;
}

/// Of a view's lines on the sheet, without pen widths.
inline QRectF extent_of(const line_drawing::SheetGroup& group) {
    QRectF extent;
    for (const line_drawing::SheetLayer& layer : group.layers)
        for (const line_drawing::SheetPath& path : layer.paths)
            extent = extent.united(painter_path(path.path).boundingRect());
    return extent;
}

inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

/// Of all groups.
inline line_drawing::Words texts_of(const line_drawing::Sheet& sheet) {
    line_drawing::Words texts;
    for (const line_drawing::SheetGroup& group : sheet.groups)
        for (const line_drawing::SheetLayer& layer : group.layers)
            for (const line_drawing::SheetText& text : layer.texts)
                texts.push_back(text.text);
    return texts;
}

/// Of closed loops that do not cross, less their holes.
inline double area_of(const line_drawing::SheetPath& path) {
    const auto loops = painter_path(path.path).toSubpathPolygons();
    double sum = 0;
    for (const QPolygonF& loop : loops) {
        double twice = 0;
        for (int i = 1; i < loop.size(); ++i)
            twice += loop[i - 1].x() * loop[i].y() - loop[i - 1].y() * loop[i].x();
        bool is_hole = false;
        for (const QPolygonF& other : loops)
            if (&other != &loop && other.containsPoint(loop[0], Qt::OddEvenFill))
                is_hole = !is_hole;
        sum += (is_hole ? -0.5 : 0.5) * std::abs(twice);
    }
    return sum;
}

}  // namespace sheet_helpers
