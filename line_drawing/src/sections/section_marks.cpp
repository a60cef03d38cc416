// SPDX-License-Identifier: GPL-3.0-or-later
#include "sections/section_marks.h"

#include <cmath>

namespace line_drawing {
namespace {

using Eigen::Vector2d;

constexpr double mark_reach = 9;  // how far marks stand out from the surface, mm on the sheet
// likewise
constexpr double mark_gap = 1, mark_length = 4, shaft_length = 3.5, head_length = 2,
                 head_width = 1.2, letter_height = 3.5, letter_distance = 2.2;
constexpr double capital_height = 0.72;  // of a font's height

SheetPath lineOf(const Vector2d& begin, const Vector2d& end, double pen) {
    SheetPath line{{}, pen};
    line.path.moveTo(begin);
    line.path.lineTo(end);
    return line;
}

SheetPath arrowHead(const Vector2d& tip, const Vector2d& direction) {
    const Vector2d across(-direction.y(), direction.x()), base = tip - head_length * direction;
    SheetPath head;
    head.path.fill_rule = FillRule::NonZero;
    head.path.moveTo(tip);
    head.path.lineTo(base + head_width / 2 * across);
    head.path.lineTo(base - head_width / 2 * across);
    head.path.close();
    return head;
}

/// How far a rectangle reaches from `from` along `direction`.
double reachOf(const Eigen::AlignedBox2d& place, const Vector2d& from, const Vector2d& direction) {
    using Box = Eigen::AlignedBox2d;
    double reach = 0;
    for (const Box::CornerType corner :
         {Box::TopLeft, Box::TopRight, Box::BottomLeft, Box::BottomRight})
        reach = std::max(reach, direction.dot(place.corner(corner) - from));
    return reach;
}

/// From a view, whose y points up.
Vector2d onSheet(const Vector2d& direction) {
    return {direction.x(), -direction.y()};
}

/// Towards `direction`, in the sheet's coordinates.
void addEnd(const Vector2d& surface_end, const Vector2d& direction, const Vector2d& looking,
            const std::string& letter, const SheetOptions& options, SheetLayer& layer) {
    const Vector2d begin = surface_end + mark_gap * direction,
                   end = begin + mark_length * direction;
    const Vector2d foot = end - direction * options.pens[std::size_t(LineClass::Outline)] / 2;
    const Vector2d tip = foot + shaft_length * looking;
    layer.paths.push_back(lineOf(begin, end, options.pens[std::size_t(LineClass::Outline)]));
    layer.paths.push_back(
        lineOf(foot, tip - head_length / 2 * looking, options.pens[std::size_t(LineClass::Inner)]));
    layer.paths.push_back(arrowHead(tip, looking));
    const Vector2d middle = end + letter_distance * direction;
    layer.texts.push_back({{middle.x(), middle.y() + capital_height * letter_height / 2},
                           letter_height,
                           TextAnchor::Middle,
                           letter});
}

}  // namespace

std::vector<SectionMark> marksOf(const ViewFrame& frame, const SheetOptions& options,
                                 const Eigen::AlignedBox3d& box) {
    constexpr double on_edge = 1e-9;
    std::vector<SectionMark> marks;
    if (frame.eye) return marks;  // sees hardly a plane from its edge
    for (std::size_t i = 0; i < options.sections.size(); ++i) {
        const Section& section = options.sections[i];
        if (std::abs(frame.towards_viewer[section.axis]) > on_edge) continue;
        const Vector2d across(frame.right[section.axis], frame.up[section.axis]);
        const Eigen::Vector3d sight = -frameOfSection(section, options.up).towards_viewer;
        const double offset = placeOnAxis(section, box) - box.center()[section.axis];
        marks.push_back({letterOf(i),
                         options.mm_per_unit * offset * across,
                         {across.y(), -across.x()},
                         {frame.right.dot(sight), frame.up.dot(sight)}});
    }
    return marks;
}

Vector2d roomOfMarks(const DrawnView& view) {
    Vector2d room(0, 0);
    for (const SectionMark& mark : view.marks)
        room = room.cwiseMax(mark_reach * mark.along.cwiseAbs());
    return room;
}

SheetLayer drawMarks(const DrawnView& view, const Placement& placement,
                     const SheetOptions& options) {
    const Eigen::AlignedBox2d place = placement.onSheet(view.bounds);
    SheetLayer layer{"marks", "Marks of sections", {}, {}};
    for (const SectionMark& mark : view.marks) {
        const Vector2d at = placement.onSheet(mark.point), looking = onSheet(mark.looking);
        for (const Vector2d& direction : {onSheet(mark.along), Vector2d(-onSheet(mark.along))})
            addEnd(at + reachOf(place, at, direction) * direction, direction, looking, mark.letter,
                   options, layer);
    }
    return layer;
}

}  // namespace line_drawing
