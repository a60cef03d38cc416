// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/make_sheet.h"

#include <algorithm>
#include <cmath>

#include "observer.h"
#include "progress_part.h"
#include "sheet_furniture.h"
#include "view_drawing.h"
#include "words.h"

namespace line_drawing {
namespace {

using laplacian_lines::Progress;
using laplacian_lines::TriangleMesh;

constexpr double sight_share = 0.4;  // of the work: what is done before the first view

void check(const SheetOptions& options) {
    if (options.views.empty() && options.sections.empty()) refuse("A drawing needs a view.");
    if (!(options.mm_per_unit > 0) || !std::isfinite(options.mm_per_unit))
        refuse("The unit of the mesh has to be a positive length.");
    if (!(options.tolerance >= 0.001 && options.tolerance <= 10))
        refuse("The tolerance of curves has to be between 0.001 and 10 mm.");
    if (!(options.shortest_line >= 0)) refuse("The shortest line has to be 0 mm or more.");
    for (const double pen : options.pens)
        if (!(pen > 0 && pen <= 10))
            refuse("The width of a pen has to be more than 0, up to 10 mm.");
}

<<<<<<< HEAD
/// As their marks, if any view has these.
void nameSections(std::vector<DrawnView>& views) {
    const bool has_marks = std::any_of(views.begin(), views.end(),
                                       [](const DrawnView& view) { return !view.marks.empty(); });
    std::size_t number = 0;
    for (DrawnView& view : views)
        if (view.is_section && has_marks) {
            const QString letter = letterOf(number++);
            view.frame.name = letter + "–" + letter;
        }
=======
/// Looks at the mesh from all sides.
class Observer {
public:
    Observer(const TriangleMesh& mesh, const laplacian_lines::Field& field,
             const SheetOptions& options, const Progress& progress)
        : mesh_(mesh),
          options_(options),
          box_(boundsOf(mesh)),
          extractor_(mesh, field, part(progress, 0, extractor_share)),
          visibility_(mesh, field, part(progress, extractor_share, sight_share)) {}

    DrawnView stand(const ViewFrame& frame) const {
        const double unit = options_.mm_per_unit;
        const Eigen::AlignedBox2d bounds = boundsOf(mesh_, frame, box_.center());
        return {frame, {unit * bounds.min(), unit * bounds.max()}, {}};
    }
    void look(DrawnView& drawn, const Progress& progress) {
        auto view = laplacian_lines::View::orthographic(drawn.frame.towards_viewer);
        if (options_.light) view.light = inMesh(*options_.light, drawn.frame);
        laplacian_lines::LineSet lines;
        extractor_.extract(view, options_.style, scratch_, lines);
        lines = visibility_.visible_parts(view, lines, progress);
        drawn.lines = project(lines, drawn.frame, box_.center(), options_.mm_per_unit);
    }
    /// What a section cuts, without what lies behind it.
    DrawnView cut(const Section& section) const {
        DrawnView drawn = stand(frameOfSection(section, options_.up));
        const double height = box_.min()[section.axis] + section.share * box_.sizes()[section.axis];
        for (const Cut& cut : cutMesh(mesh_, section.axis, height))
            drawn.lines.push_back(project(cut, drawn.frame, box_.center(), options_.mm_per_unit));
        return drawn;
    }
    Eigen::Vector3d objectSize() const { return options_.mm_per_unit * box_.sizes(); }

private:
    const TriangleMesh& mesh_;
    const SheetOptions& options_;
    const Eigen::AlignedBox3d box_;
    const laplacian_lines::LineExtractor extractor_;
    const laplacian_lines::LineVisibility visibility_;
    laplacian_lines::ExtractionScratch scratch_;
};

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

/// Thin lines first: outlines lie over them.
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
>>>>>>> export
}

}  // namespace

Sheet makeSheet(const TriangleMesh& mesh, const laplacian_lines::Field& field,
                const SheetOptions& options, const Progress& progress) {
    check(options);
    Observer observer(mesh, field, part(progress, 0, sight_share));
    std::vector<DrawnView> views;
    for (const ViewFrame& frame : options.views)
        views.push_back(observer.stand(frame, options));
    for (const Section& section : options.sections)
        views.push_back(observer.cut(section, options));
    nameSections(views);
    const SheetLayout layout = layOut(views, options);  // before much work, since it may refuse
    const auto share = [&](std::size_t views_done) {
        const double all = std::max<double>(1, double(options.views.size()));
        return sight_share + (1 - sight_share) * double(views_done) / all;
    };
    for (std::size_t i = 0; i < options.views.size(); ++i)  // sections have their lines
<<<<<<< HEAD
        observer.look(views[i], options, part(progress, share(i), share(i + 1)));
    Sheet sheet{layout.size, options.title, {}};
=======
        observer.look(views[i], part(progress, share(i), share(i + 1)));
    Sheet sheet{layout.size, options.title, {}, layout.scale};
>>>>>>> export
    for (std::size_t i = 0; i < views.size(); ++i)
        sheet.groups.push_back(
            drawView(views[i], i + 1, layout.placements[i], layout.places[i], options));
    SheetGroup furniture =
        drawFurniture(views, layout, options.mm_per_unit * observer.objectSize(), options);
    if (!furniture.layers.empty()) sheet.groups.push_back(std::move(furniture));
    return sheet;
}

}  // namespace line_drawing
