// SPDX-License-Identifier: GPL-3.0-or-later
// A view's marks on the page: lines become strokes (draw_lines() tells the order), closed outlines
// areas, cut walls areas or hatching, in a layer for each class of lines.
#include "sheet/view_drawing.h"

#include <algorithm>
#include <utility>

#include "line_drawing/words.h"
#include "planes/corners.h"
#include "planes/hatching.h"
#include "sections/section_marks.h"
#include "strokes/drawn_lines.h"
#include "strokes/refining.h"
#include "strokes/strokes.h"

namespace line_drawing {
namespace {

/// Nearer lines merge in print, in widths of outlines.
constexpr double kDoubleReach = 0.4;
constexpr double kAreaTone = 0.9;
constexpr double kAreaTolerance = 0.001;    // mm: the last digit of SVG and PDF
constexpr double kContourSmoothing = 0.16;  // contours move by so much of the width of outlines
constexpr double kInnerSmoothing = 0.6;     // inner lines by so much of their width
constexpr double kLeastShare = 0.03;        // of the picture: least length of isolated lines
constexpr double kHatchSpacing = 1.5;       // mm
constexpr double kTouching = 0.1, kContactStep = 0.5;  // mm: nearer walls look like neighbours

struct LayerName {
    const char *key, *name;
};
/// By LineClass.
constexpr LayerName kLayerNames[kLineClassCount] = {
    {"outline", "Outlines"},   {"contour", "Contours"}, {"edge", "Edges"},
    {"inner", "Inner lines"},  {"fine", "Fine lines"},  {"section", "Sections"},
    {"hidden", "Hidden lines"}};

std::vector<DrawnLine> on_sheet(std::vector<DrawnLine> lines, const Placement& placement) {
    for (DrawnLine& line : lines) {
        line.jump *= placement.scale;
        for (DrawnPoint& point : line.points)
            point.position = placement.on_sheet(point.position);
    }
    return lines;
}

std::vector<MergedWalls> on_sheet(std::vector<MergedWalls> walls, const Placement& placement) {
    for (MergedWalls& merged : walls)
        for (Wall& wall : merged)
            for (auto& loop : wall)
                for (Eigen::Vector2d& p : loop)
                    p = placement.on_sheet(p);
    return walls;
}

using Loop = std::vector<Eigen::Vector2d>;

/// A cut area of the section, with the direction of its hatching.
struct HatchedWall {
    std::vector<Loop> loops;  // as points at most kContactStep apart
    DrawnLines edges{kContactStep};
    Eigen::AlignedBox2d box;
    double rise = -1;

    explicit HatchedWall(const MergedWalls& walls) {
        for (const Wall& wall : walls)
            for (const Loop& loop : wall) {
                loops.push_back(refine(loop, kContactStep));
                edges.add(loop);
                for (const Eigen::Vector2d& p : loop)
                    box.extend(p);
            }
    }

    /// The number of points that touch another wall.
    std::size_t contacts_with(const HatchedWall& other) const {
        const Eigen::Vector2d reach = Eigen::Vector2d::Constant(kTouching);
        if (!box.intersects({other.box.min() - reach, other.box.max() + reach})) return 0;
        std::size_t count = 0;
        for (const Loop& loop : loops)
            for (const Eigen::Vector2d& p : loop)
                count += other.edges.is_near(p, DrawnLines::kNoLine, kTouching);
        return count;
    }
};

/// A wall has the direction opposite to that of the walls that it touches for longest (ISO 128-3),
/// or else to that of the wall before.
void add_hatching(const std::vector<MergedWalls>& walls, const Pens& pens,
                  std::vector<DrawnLine>& lines) {
    // weights of fine lines are shares of an inner line's width
    const double weight = pens[std::size_t(LineClass::Fine)] / pens[std::size_t(LineClass::Inner)];
    std::vector<HatchedWall> hatched;
    for (const MergedWalls& merged : walls) {
        HatchedWall wall(merged);
        if (wall.loops.empty()) continue;
        double around = 0;
        for (const HatchedWall& other : hatched)
            around += other.rise * double(wall.contacts_with(other));
        if (around == 0 && !hatched.empty()) around = hatched.back().rise;
        wall.rise = around < 0 ? 1 : -1;
        for (const auto& ends :
             hatch(merged, Eigen::Vector2d(1, wall.rise).normalized(), kHatchSpacing))
            lines.push_back({LineClass::Fine, false, {{ends[0], weight}, {ends[1], weight}}});
        hatched.push_back(std::move(wall));
    }
}

SheetPath filled(const Wall& loops, double tone = 0) {
    SheetPath area;
    area.tone = tone;
    for (const Loop& loop : loops)
        area.path.add_polygon(loop);
    return area;
}

/// Simplifies a closed loop, also where it begins.
Loop corners_of(Loop loop) {
    const auto by_place = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
    };
    const auto leftmost = std::min_element(loop.begin(), loop.end(), by_place);
    begin_at(std::size_t(leftmost - loop.begin()), loop);
    const auto rightmost =
        std::size_t(std::max_element(loop.begin(), loop.end(), by_place) - loop.begin());
    Loop corners;
    for (const auto& [first, last] :
         {std::pair(std::size_t(0), rightmost), std::pair(rightmost, loop.size() - 1)})
        for (const std::size_t i : line_drawing::corners_of(loop, first, last, kAreaTolerance))
            corners.push_back(loop[i]);
    return corners;
}

/// The exact area that closed outlines enclose, before smoothing and cleaning.
SheetPath area_of(const std::vector<DrawnLine>& lines, const Placement& placement) {
    Wall loops;
    for (const DrawnLine& line : on_sheet(lines, placement))
        if (line.line_class == LineClass::Outline && line.closed && line.points.size() > 3)
            loops.push_back(corners_of(positions_of(line)));
    return filled(loops, kAreaTone);
}

/// Of the drawing, or of each object.
SheetLayer areas(const DrawnView& view, const Placement& placement) {
    SheetLayer layer{"area", "Area", {}, {}};
    for (const auto& silhouette : view.silhouettes)
        layer.paths.push_back(area_of(silhouette, placement));
    if (view.silhouettes.empty()) layer.paths.push_back(area_of(view.lines, placement));
    return layer;
}

}  // namespace

std::vector<DrawnLine> draw_lines(const DrawnView& view, const Placement& placement,
                                  const SheetOptions& options) {
    const double pen = options.pens[std::size_t(LineClass::Outline)],
                 inner_pen = options.pens[std::size_t(LineClass::Inner)];
    std::vector<DrawnLine> lines = on_sheet(view.lines, placement);
    lines = without_specks(std::move(lines), options);
    smooth_contours(lines, kContourSmoothing * pen);
    lines = without_doubles(std::move(lines), kDoubleReach * pen);
    even_out_classes(lines, kDoubleReach * pen);
    const bool is_tapered = options.strokes == StrokeStyle::Tapered;
    const auto make_whole = [&] { lines = chain(std::move(lines), options.pens, is_tapered); };
    cut_hooks(lines, inner_pen);
    make_whole();
    cut_hooks(lines, inner_pen);  // again, of lines that were too short before joining
    lines = thin_out(std::move(lines), options.pens);
    make_whole();  // again, over gaps that lines have left
    const std::vector<MetEnd> met = join_ends(lines, inner_pen);
    smooth_inner_lines(lines, kInnerSmoothing * inner_pen);
    follow_met(met, inner_pen, lines);
    const double size = placement.on_sheet(view.bounds).sizes().maxCoeff();
    return without_fragments(std::move(lines), kLeastShare * size, inner_pen);
}

SheetGroup draw_view(const DrawnView& view, std::size_t number, const Placement& placement,
                     const SheetOptions& options) {
    const bool has_name = view.frame.side != Side::Other;
    const std::string key = has_name ? lower(view.frame.name) : "view-" + std::to_string(number);
    SheetGroup group{key, view.frame.name, {}};
    std::vector<DrawnLine> lines = draw_lines(view, placement, options);
    if (options.strokes == StrokeStyle::Tapered) point_ends(lines, options.pens);
    const std::vector<MergedWalls> walls = on_sheet(view.walls, placement);
    if (options.wall == WallStyle::Hatched) add_hatching(walls, options.pens, lines);
    if (options.area != OutlineArea::None) group.layers.push_back(areas(view, placement));
    for (std::size_t c = kLineClassCount; c-- > 0;) {
        SheetLayer layer{kLayerNames[c].key, kLayerNames[c].name, {}, {}};
        if (c == std::size_t(LineClass::Section) && options.wall == WallStyle::Filled)
            for (const MergedWalls& merged : walls)
                for (const Wall& wall : merged)
                    if (!wall.empty()) layer.paths.push_back(filled(wall));
        for (const DrawnLine& line : lines)
            if (std::size_t(line.line_class) == c)
                if (auto stroke = draw_stroke(line, options))
                    layer.paths.push_back(std::move(*stroke));
        group.layers.push_back(std::move(layer));
    }
    if (!view.marks.empty()) group.layers.push_back(draw_marks(view, placement, options));
    return group;
}

}  // namespace line_drawing
