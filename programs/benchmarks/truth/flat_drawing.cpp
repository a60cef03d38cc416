// SPDX-License-Identifier: GPL-3.0-or-later
#include "flat_drawing.h"

#include <Eigen/Geometry>
#include <stdexcept>

#include "laplacian_lines/precompute.h"
#include "line_drawing/make_sheet.h"

namespace benchmarks {
namespace {

using laplacian_lines::LineKind;
using laplacian_lines::TriangleMesh;

constexpr double closing_gap = 0.01;  // mm, between the ends of what counts as closed

line_drawing::SheetOptions options_of(const PlaneFrame& frame, double mm_per_unit) {
    line_drawing::SheetOptions options;
    line_drawing::ViewFrame view;
    view.side = line_drawing::Side::Other;
    view.name = "view";
    view.right = frame.right;
    view.up = frame.up;
    view.towards_viewer = frame.viewer;
    options.views = {view};
    options.scale = 1;
    options.mm_per_unit = mm_per_unit;
    options.paper = "fit";
    options.strokes = line_drawing::StrokeStyle::Plain;
    options.has_view_names = options.has_scale_bar = options.has_notes = false;
    options.style.shows = {};
    for (const LineKind kind : {LineKind::Contour, LineKind::Border, LineKind::Crease})
        options.style.shows[kind] = true;
    return options;
}

/// Of the projected surface, mm.
Eigen::AlignedBox2d extent_of(const TriangleMesh& mesh, const PlaneFrame& frame,
                              const DrawingSetup& setup) {
    Eigen::AlignedBox2d extent;
    for (const laplacian_lines::Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle) {
            const Eigen::Vector3d& p = mesh.positions[v];
            if (p.allFinite()) extent.extend(setup.mm_per_unit * frame.project(p - setup.origin));
        }
    return extent;
}

std::vector<line_drawing::Sheet> sheets_of(const TriangleMesh& mesh,
                                           const std::vector<PlaneFrame>& frames,
                                           double mm_per_unit) {
    const laplacian_lines::Field field = laplacian_lines::precompute(mesh);
    std::vector<line_drawing::SheetOptions> options;
    for (const PlaneFrame& frame : frames)
        options.push_back(options_of(frame, mm_per_unit));
    return line_drawing::makeSheets({{mesh, &field}}, options);
}

/// Centred at the origin.
TriangleMesh box(const Eigen::Vector3d& size) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.positions.push_back(size.cwiseProduct(Eigen::Vector3d(
            (corner & 1) - 0.5, ((corner >> 1) & 1) - 0.5, ((corner >> 2) & 1) - 0.5)));
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

/// What the lines of a box take on a sheet of its own, whose width is returned as well.
Eigen::AlignedBox2d ink_of_box(const Eigen::Vector3d& size, double& sheet_width) {
    const PlaneFrame front = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const auto sheets = sheets_of(box(size), {front}, 1);
    sheet_width = sheets.at(0).size.x();
    Eigen::AlignedBox2d ink;
    for (const DrawnPath& path : benchmarks::flattened(sheets[0].groups.at(0)))
        for (const PlanePoint& p : path.points)
            ink.extend(p);
    return ink;
}

/// Above a view on its sheet, by drawings of two boxes.
double upper_margin() {
    const auto margin_of = [](const Eigen::Vector3d& size) {
        double width = 0;
        const Eigen::AlignedBox2d ink = ink_of_box(size, width);
        if (ink.isEmpty() || (ink.sizes() - size.head<2>()).norm() > 0.05 ||
            std::abs(ink.center().x() - width / 2) > 0.05)
            throw std::runtime_error("a box is not drawn in the middle of its sheet");
        return ink.min().y();
    };
    const double margin = margin_of({100, 100, 100});
    if (std::abs(margin_of({40, 60, 30}) - margin) > 0.05)
        throw std::runtime_error("views of different size have different margins");
    return margin;
}

/// From a sheet to its view's coordinates; the view's extent is known.
class SheetPlace {
public:
    SheetPlace(const Eigen::Vector2d& sheet, const Eigen::AlignedBox2d& extent) {
        static const double margin = upper_margin();
        shift_ = {sheet.x() / 2 - extent.center().x(), margin + extent.max().y()};
    }
    PlanePoint in_view(const PlanePoint& p) const {
        return {p.x() - shift_.x(), shift_.y() - p.y()};
    }

private:
    PlanePoint shift_;
};

}  // namespace

PlaneLines lines_of(const DrawnPaths& paths) {
    PlaneLines lines;
    for (const DrawnPath& path : paths)
        lines.push_back(path.points);
    return lines;
}

DrawnPaths flattened(const line_drawing::SheetGroup& view) {
    DrawnPaths paths;
    for (const line_drawing::SheetLayer& layer : view.layers)
        for (const line_drawing::SheetPath& path : layer.paths) {
            if (!(path.pen_width > 0)) continue;  // an area
            for (PlaneLine& line : path.path.flattened(flatness))
                if (line.size() > 1) {
                    const bool is_closed = (line.front() - line.back()).norm() < closing_gap;
                    paths.push_back({std::move(line), layer.key == "outline", is_closed});
                }
        }
    return paths;
}

std::vector<DrawnPaths> drawings_of(const TriangleMesh& mesh, const std::vector<PlaneFrame>& frames,
                                    const DrawingSetup& setup) {
    std::vector<DrawnPaths> drawings;
    const auto sheets = sheets_of(mesh, frames, setup.mm_per_unit);
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        DrawnPaths paths = flattened(sheets[i].groups.at(0));
        const SheetPlace place(sheets[i].size, extent_of(mesh, frames[i], setup));
        for (DrawnPath& path : paths)
            for (PlanePoint& p : path.points)
                p = place.in_view(p);
        drawings.push_back(std::move(paths));
    }
    return drawings;
}

}  // namespace benchmarks
