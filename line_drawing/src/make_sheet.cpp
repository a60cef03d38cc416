// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/make_sheet.h"

#include <cmath>

#include "laplacian_lines/error.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_visibility.h"
#include "sheet_furniture.h"

namespace line_drawing {
namespace {

using laplacian_lines::Error;
using laplacian_lines::ErrorCode;
using laplacian_lines::Progress;
using laplacian_lines::TriangleMesh;

// What is done of the work when each step has ended.
constexpr double extractor_share = 0.3, sight_share = 0.4, views_share = 0.95;

struct LayerName {
    const char *key, *name;
};
/// By LineClass.
constexpr LayerName layer_names[line_class_count] = {
    {"outline", "Outlines"}, {"inner", "Inner lines"}, {"fine", "Fine lines"}};

/// A part of a longer work.
Progress part(const Progress& progress, double begin, double end) {
    if (!progress) return {};
    return [=](double done, const char* stage) {
        return progress(begin + (end - begin) * done, stage);
    };
}

void check(const SheetOptions& options) {
    const auto refuse = [](const char* why) { throw Error(ErrorCode::InvalidOption, why); };
    if (options.views.empty()) refuse("A drawing needs a view.");
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
          visibility_(mesh, field.scale, part(progress, extractor_share, sight_share)) {}

    DrawnView look(const ViewFrame& frame, const Progress& progress) {
        const auto view = laplacian_lines::View::orthographic(frame.towards_viewer);
        laplacian_lines::LineSet lines;
        extractor_.extract(view, options_.style, scratch_, lines);
        lines = visibility_.visible_parts(view, lines, progress);
        const double unit = options_.mm_per_unit;
        const Eigen::AlignedBox2d bounds = boundsOf(mesh_, frame, box_.center());
        return {frame,
                {unit * bounds.min(), unit * bounds.max()},
                project(lines, frame, box_.center(), unit)};
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

/// Thin lines first: outlines lie over them.
SheetGroup drawView(const DrawnView& view, std::size_t number, const Placement& placement,
                    const SheetOptions& options) {
    const bool has_name = view.frame.side != Side::Other;
    SheetGroup group{
        has_name ? view.frame.name.toLower() : QString("view-%1").arg(number), view.frame.name, {}};
    for (std::size_t c = line_class_count; c-- > 0;) {
        SheetLayer layer{layer_names[c].key, layer_names[c].name, {}, {}};
        for (const DrawnLine& line : view.lines)
            if (std::size_t(line.line_class) == c)
                if (auto stroke = drawStroke(line, placement, options))
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
    const double step = (views_share - sight_share) / double(options.views.size());
    for (const ViewFrame& frame : options.views) {
        const double begin = sight_share + step * double(views.size());
        views.push_back(observer.look(frame, part(progress, begin, begin + step)));
    }
    const SheetLayout layout = layOut(views, options);
    Sheet sheet{layout.size, options.title, {}};
    for (std::size_t i = 0; i < views.size(); ++i)
        sheet.groups.push_back(drawView(views[i], i + 1, layout.placements[i], options));
    sheet.groups.push_back(drawFurniture(views, layout, observer.objectSize(), options));
    return sheet;
}

}  // namespace line_drawing
