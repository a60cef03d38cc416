// SPDX-License-Identifier: GPL-3.0-or-later
#include "inner_strokes.h"

#include "line_drawing/bounds.h"
#include "line_drawing/make_sheet.h"

namespace benchmarks {

using namespace line_drawing;
using laplacian_lines::TriangleMesh;

constexpr double flatness = 0.5;  // mm

SheetOptions front_options(const TriangleMesh& mesh, double width) {
    SheetOptions options;
    options.views = parseViews("front", UpAxis::Y);
    options.paper = "fit";
    options.area = OutlineArea::Filled;
    options.scale = width / boundsOf(mesh).sizes().x();
    return options;
}

bool is_inner(const SheetLayer& layer) {
    return layer.key == "inner" || layer.key == "fine";
}

QPainterPath covered_area(const Sheet& sheet) {
    QPainterPath area;
    for (const SheetLayer& layer : sheet.groups[0].layers)
        if (layer.key == "area")
            for (const SheetPath& path : layer.paths)
                area.addPath(sheet_painting::painterPath(path.path));
    return area;
}

std::vector<std::vector<Eigen::Vector2d>> inner_strokes(const TriangleMesh& mesh, double width) {
    SheetOptions options = front_options(mesh, width);
    options.strokes = StrokeStyle::Plain;
    const Sheet sheet = makeSheets({{mesh, nullptr}}, {options}).front();
    const QPointF middle = covered_area(sheet).boundingRect().center();
    const Eigen::Vector3d centre = boundsOf(mesh).center();
    std::vector<std::vector<Eigen::Vector2d>> strokes;
    for (const SheetLayer& layer : sheet.groups[0].layers)
        for (const SheetPath& path : layer.paths) {
            if (!is_inner(layer)) continue;
            for (const auto& line : path.path.flattened(flatness)) {
                strokes.emplace_back();
                for (const Eigen::Vector2d& p : line)
                    strokes.back().emplace_back(centre.x() + (p.x() - middle.x()) / options.scale,
                                                centre.y() - (p.y() - middle.y()) / options.scale);
            }
        }
    return strokes;
}

}  // namespace benchmarks
