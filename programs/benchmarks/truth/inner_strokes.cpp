// SPDX-License-Identifier: GPL-3.0-or-later
#include "inner_strokes.h"

#include "flat_drawing.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/object.h"

namespace benchmarks {

using namespace line_drawing;
using laplacian_lines::TriangleMesh;

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
                area.addPath(painterPath(path.path));
    return area;
}

DrawnStrokes drawn_strokes(const TriangleMesh& mesh, double width) {
    SheetOptions options = front_options(mesh, width);
    options.strokes = StrokeStyle::Plain;
    const Sheet sheet = makeSheets({{mesh, nullptr}}, {options}).front();
    const QPointF middle = covered_area(sheet).boundingRect().center();
    const Eigen::Vector3d centre = boundsOf(mesh).center();
    DrawnStrokes strokes;
    for (const SheetLayer& layer : sheet.groups[0].layers)
        for (const SheetPath& path : layer.paths) {
            if (!(path.pen_width > 0)) continue;  // an area
            for (PlaneLine& line : path.path.flattened(flatness)) {
                for (PlanePoint& p : line)
                    p = {centre.x() + (p.x() - middle.x()) / options.scale,
                         centre.y() - (p.y() - middle.y()) / options.scale};
                if (is_inner(layer)) strokes.inner.push_back(line);
                strokes.all.push_back(std::move(line));
            }
        }
    return strokes;
}

}  // namespace benchmarks
