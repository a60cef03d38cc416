// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_measures.h"

#include <Eigen/Geometry>

#include "laplacian_lines/precompute.h"
#include "line_drawing/make_sheet.h"

namespace benchmarks {
namespace {

using laplacian_lines::LineKind;
using laplacian_lines::TriangleMesh;
using line_drawing::ViewFrame;

constexpr double kFlatness = 0.002;  // mm
constexpr double kUpperMargin = 10;  // mm, above a view: kSheetMargin of sheet_layout.h

line_drawing::SheetOptions options_of(const ViewFrame& frame) {
    line_drawing::SheetOptions options;
    options.views = {frame};
    options.scale = 1;
    options.paper = "fit";
    options.strokes = line_drawing::StrokeStyle::Plain;
    options.has_annotations = false;
    options.style.shows = {};
    for (const LineKind kind : {LineKind::Contour, LineKind::Border, LineKind::Crease})
        options.style.shows[kind] = true;
    return options;
}

/// From a sheet, y down, where the view lies in the middle at the top.
PlanePoint shift_of(const line_drawing::Sheet& sheet, const TriangleMesh& mesh,
                    const ViewFrame& frame) {
    Eigen::AlignedBox2d extent;
    for (const laplacian_lines::Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle)
            extent.extend(project(mesh.positions[v], frame));
    return {extent.center().x() - sheet.size.x() / 2, extent.max().y() + kUpperMargin};
}

PlaneLines lines_of(const line_drawing::SheetGroup& view, const PlanePoint& shift) {
    PlaneLines lines;
    for (const line_drawing::SheetLayer& layer : view.layers)
        for (const line_drawing::SheetPath& path : layer.paths) {
            if (!(path.pen_width > 0)) continue;  // an area
            for (PlaneLine& line : path.path.flattened(kFlatness)) {
                if (line.size() < 2) continue;
                for (PlanePoint& p : line)
                    p = {shift.x() + p.x(), shift.y() - p.y()};
                lines.push_back(std::move(line));
            }
        }
    return lines;
}

}  // namespace

std::vector<PlaneLines> drawings_of(const TriangleMesh& mesh,
                                    const std::vector<ViewFrame>& frames) {
    const laplacian_lines::Field field = laplacian_lines::precompute(mesh);
    std::vector<line_drawing::SheetOptions> options;
    for (const ViewFrame& frame : frames)
        options.push_back(options_of(frame));
    const auto sheets = line_drawing::make_sheets({{mesh, &field}}, options);
    std::vector<PlaneLines> drawings;
    for (std::size_t i = 0; i < sheets.size(); ++i)
        drawings.push_back(lines_of(sheets[i].groups.at(0), shift_of(sheets[i], mesh, frames[i])));
    return drawings;
}

}  // namespace benchmarks
