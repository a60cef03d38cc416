// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/make_sheet.h"

#include <algorithm>
#include <cmath>

#include "cutting.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_visibility.h"
#include "overlaps.h"
#include "sheet_furniture.h"
#include "words.h"

namespace line_drawing {
namespace {

using laplacian_lines::Progress;
using laplacian_lines::TriangleMesh;

// What is done of the work when each step has ended.
constexpr double extractor_share = 0.3, sight_share = 0.4;

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

/// A part of a longer work.
Progress part(const Progress& progress, double begin, double end) {
    if (!progress) return {};
    return [=](double done, const char* stage) {
        return progress((1 - done) * begin + done * end, stage);
    };
}

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
}

}  // namespace

Sheet makeSheet(const TriangleMesh& mesh, const laplacian_lines::Field& field,
                const SheetOptions& options, const Progress& progress) {
    check(options);
    Observer observer(mesh, field, options, progress);
    std::vector<DrawnView> views;
    for (const ViewFrame& frame : options.views)
        views.push_back(observer.stand(frame));
    for (const Section& section : options.sections)
        views.push_back(observer.cut(section));
    const SheetLayout layout = layOut(views, options);  // before much work, since it may refuse
    const auto share = [&](std::size_t views_done) {
        const double all = std::max<double>(1, double(options.views.size()));
        return sight_share + (1 - sight_share) * double(views_done) / all;
    };
    for (std::size_t i = 0; i < options.views.size(); ++i)  // sections have their lines
        observer.look(views[i], part(progress, share(i), share(i + 1)));
    Sheet sheet{layout.size, options.title, {}, layout.scale};
    for (std::size_t i = 0; i < views.size(); ++i)
        sheet.groups.push_back(drawView(views[i], i + 1, layout.placements[i], options));
    SheetGroup furniture = drawFurniture(views, layout, observer.objectSize(), options);
    if (!furniture.layers.empty()) sheet.groups.push_back(std::move(furniture));
    return sheet;
}

}  // namespace line_drawing
