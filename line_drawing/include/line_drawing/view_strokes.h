// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/progress.h"
#include "line_drawing/object.h"
#include "line_drawing/sheet_options.h"
#include "line_drawing/view_frame.h"

namespace line_drawing {

/// Default length of the longer side of a view on paper, mm: most of A4.
constexpr double kUsualViewSize = 200;

/// The strokes of a view as make_sheets() draws it with this size on paper, mm of its longer side,
/// in space: joined, thinned out, smoothed. Points have the depth of the line that they come from,
/// so strokes end where one line continues behind another. Weights are shares of the width of
/// outlines, contours or inner lines; opacities are 1, jumps 0; points have no nodes. Kinds,
/// strengths and slopes are those of most of the stroke. Ignores views, sections, scale, unit,
/// paper and annotations of the options.
/// @throws laplacian_lines::Error: Cancelled; InvalidOption if the eye is inside the surface or
/// sees nothing; InvalidMesh, EmptyMesh, FieldMismatch
std::vector<laplacian_lines::ViewLine> strokes_of(const Objects& objects, const ViewFrame& frame,
                                                  SheetOptions options,
                                                  const laplacian_lines::Progress& progress = {},
                                                  double size = kUsualViewSize);

}  // namespace line_drawing
