// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/sheet.h"
#include "line_drawing/sheet_options.h"
#include "painter_path.h"
#include "plane_lines.h"

namespace benchmarks {

/// A front view, so many mm wide, alone on its sheet; a layer has the area that the mesh covers.
line_drawing::SheetOptions front_options(const laplacian_lines::TriangleMesh& mesh, double width);

bool is_inner(const line_drawing::SheetLayer& layer);

/// By the mesh.
QPainterPath covered_area(const line_drawing::Sheet& sheet);

/// By front_options() with even strokes, in the mesh's x and y.
struct DrawnStrokes {
    PlaneLines all, inner;
};
DrawnStrokes drawn_strokes(const laplacian_lines::TriangleMesh& mesh, double width);

}  // namespace benchmarks
