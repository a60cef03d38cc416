// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <stdexcept>

#include "generators.h"
#include "laplacian_lines/precompute.h"
#include "line_drawing/make_sheet.h"

namespace made_sheets {

/// A cube of 100 mm, whose axes are the views'.
inline laplacian_lines::TriangleMesh cubeOf100() {
    laplacian_lines::TriangleMesh mesh = test_meshes::cube(4);
    for (Eigen::Vector3d& p : mesh.positions)
        p *= 50;
    return mesh;
}

inline line_drawing::Sheet sheetOf(const laplacian_lines::TriangleMesh& mesh,
                                   const line_drawing::SheetOptions& options) {
    return line_drawing::makeSheet(mesh, laplacian_lines::precompute(mesh), options);
}

inline line_drawing::SheetOptions plainViews(const char* views, const char* paper = "a0") {
    line_drawing::SheetOptions options;
    options.views = line_drawing::parseViews(views, line_drawing::UpAxis::Z);
    options.strokes = line_drawing::StrokeStyle::Plain;
    options.paper = paper;
    options.scale = 1;
    return options;
}

inline const line_drawing::SheetLayer& layerOf(const line_drawing::SheetGroup& group,
                                               const char* key) {
    for (const line_drawing::SheetLayer& layer : group.layers)
        if (layer.key == key) return layer;
    throw std::out_of_range(key);
}

/// What the lines of a view take on the sheet, the widths of pens apart.
inline QRectF extentOf(const line_drawing::SheetGroup& group) {
    QRectF extent;
    for (const line_drawing::SheetLayer& layer : group.layers)
        for (const line_drawing::SheetPath& path : layer.paths)
            extent = extent.united(path.path.boundingRect());
    return extent;
}

}  // namespace made_sheets
