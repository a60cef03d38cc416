// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_drawing.h"

#include "cutting.h"
#include "overlaps.h"
#include "strokes.h"

namespace line_drawing {
namespace {

constexpr double double_reach = 0.2;                      // mm, within which a line doubles another
constexpr double hatch_spacing = 1.5, hatch_width = 0.5;  // mm; share of an inner line's width

struct LayerName {
    const char *key, *name;
};
/// By LineClass.
constexpr LayerName layer_names[line_class_count] = {{"outline", "Outlines"},
                                                     {"inner", "Inner lines"},
                                                     {"fine", "Fine lines"},
                                                     {"section", "Sections"}};

std::vector<DrawnLine> place(std::vector<DrawnLine> lines, const Placement& placement) {
    for (DrawnLine& line : lines)
        for (DrawnPoint& point : line.points)
            point.position = placement.onSheet(point.position);
    return lines;
}

/// Hatching of what closed sections enclose.
void addHatching(std::vector<DrawnLine>& lines) {
    std::vector<std::vector<Eigen::Vector2d>> loops;
    for (const DrawnLine& line : lines)
        if (line.line_class == LineClass::Section && line.closed)
            loops.push_back(positionsOf(line));
    for (const auto& ends : hatch(loops, Eigen::Vector2d(1, -1).normalized(), hatch_spacing))
        lines.push_back({LineClass::Fine, false, {{ends[0], hatch_width}, {ends[1], hatch_width}}});
}

}  // namespace

SheetGroup drawView(const DrawnView& view, std::size_t number, const Placement& placement,
                    const SheetOptions& options) {
    const bool has_name = view.frame.side != Side::Other;
    SheetGroup group{
        has_name ? view.frame.name.toLower() : QString("view-%1").arg(number), view.frame.name, {}};
    std::vector<DrawnLine> lines = withoutDoubles(place(view.lines, placement), double_reach);
    addHatching(lines);
    for (std::size_t c = line_class_count; c-- > 0;) {
        SheetLayer layer{layer_names[c].key, layer_names[c].name, {}, {}};
        for (const DrawnLine& line : lines)
            if (std::size_t(line.line_class) == c)
                if (auto stroke = drawStroke(line, options))
                    layer.paths.push_back(std::move(*stroke));
        group.layers.push_back(std::move(layer));
    }
    return group;
}

}  // namespace line_drawing
