// SPDX-License-Identifier: GPL-3.0-or-later
#include "sections/section_marks.h"

#include <algorithm>
#include <cmath>

namespace line_drawing {
namespace {

using Eigen::Vector2d;

// mm on the sheet
constexpr double kMarkReach = 9;  // from the surface to the end of a mark
constexpr double kMarkGap = 1, kMarkLength = 4, kShaftLength = 3.5, kHeadLength = 2,
                 kHeadWidth = 1.2, kLetterHeight = 3.5, kLetterDistance = 2.2;
constexpr double kCapitalHeight = 0.72;  // of a font's height

SheetPath line_of(const Vector2d& begin, const Vector2d& end, double pen) {
    SheetPath line{{}, pen};
    line.path.move_to(begin);
    line.path.line_to(end);
    return line;
}

SheetPath arrow_head(const Vector2d& tip, const Vector2d& direction) {
    const Vector2d across(-direction.y(), direction.x()), base = tip - kHeadLength * direction;
    SheetPath head;
    head.path.fill_rule = FillRule::NonZero;
    head.path.add_polygon({tip, base + kHeadWidth / 2 * across, base - kHeadWidth / 2 * across});
    return head;
}

/// From a point in a rectangle to its border along the unit vector `direction`.
double reach_of(const Eigen::AlignedBox2d& place, const Vector2d& from, const Vector2d& direction) {
    double reach = INFINITY;
    for (const int axis : {0, 1}) {
        const double border = direction[axis] > 0 ? place.max()[axis] : place.min()[axis];
        if (direction[axis] != 0) reach = std::min(reach, (border - from[axis]) / direction[axis]);
    }
    return std::max(0., reach);
}

/// From a view, whose y points up.
Vector2d on_sheet(const Vector2d& direction) {
    return {direction.x(), -direction.y()};
}

/// Adds the end of a cutting plane's line towards `direction`. Directions are unit, on the sheet.
void add_end(const Vector2d& surface_end, const Vector2d& direction, const Vector2d& looking,
             const std::string& letter, const SheetOptions& options, SheetLayer& layer) {
    const Vector2d begin = surface_end + kMarkGap * direction,
                   end = begin + kMarkLength * direction;
    const Vector2d foot = end - direction * options.pens[std::size_t(LineClass::Outline)] / 2;
    const Vector2d tip = foot + kShaftLength * looking;
    layer.paths.push_back(line_of(begin, end, options.pens[std::size_t(LineClass::Outline)]));
    layer.paths.push_back(line_of(foot, tip - kHeadLength / 2 * looking,
                                  options.pens[std::size_t(LineClass::Inner)]));
    layer.paths.push_back(arrow_head(tip, looking));
    const Vector2d middle = end + kLetterDistance * direction;
    layer.texts.push_back({{middle.x(), middle.y() + kCapitalHeight * kLetterHeight / 2},
                           kLetterHeight,
                           TextAnchor::Middle,
                           letter});
}

}  // namespace

std::vector<SectionMark> marks_of(const ViewFrame& frame, const SheetOptions& options,
                                  const Eigen::AlignedBox3d& box) {
    constexpr double on_edge = 1e-9;
    std::vector<SectionMark> marks;
    if (frame.eye) return marks;  // in perspective hardly a plane is seen edge-on
    for (std::size_t i = 0; i < options.sections.size(); ++i) {
        const Section& section = options.sections[i];
        if (std::abs(frame.towards_viewer[section.axis]) > on_edge) continue;
        const Vector2d across(frame.right[section.axis], frame.up[section.axis]);
        const Eigen::Vector3d sight = -frame_of_section(section, options.up).towards_viewer;
        const double offset = position_on_axis(section, box) - box.center()[section.axis];
        marks.push_back({letter_of(i),
                         options.mm_per_unit * offset * across,
                         {across.y(), -across.x()},
                         {frame.right.dot(sight), frame.up.dot(sight)}});
    }
    return marks;
}

Vector2d room_of_marks(const DrawnView& view) {
    Vector2d room(0, 0);
    for (const SectionMark& mark : view.marks)
        room = room.cwiseMax(kMarkReach * mark.along.cwiseAbs());
    return room;
}

SheetLayer draw_marks(const DrawnView& view, const Placement& placement,
                      const SheetOptions& options) {
    const Eigen::AlignedBox2d place = placement.on_sheet(view.bounds);
    SheetLayer layer{"marks", "Marks of sections", {}, {}};
    for (const SectionMark& mark : view.marks) {
        const Vector2d at = placement.on_sheet(mark.point), looking = on_sheet(mark.looking);
        for (const Vector2d& direction : {on_sheet(mark.along), Vector2d(-on_sheet(mark.along))})
            add_end(at + reach_of(place, at, direction) * direction, direction, looking,
                    mark.letter, options, layer);
    }
    return layer;
}

}  // namespace line_drawing
