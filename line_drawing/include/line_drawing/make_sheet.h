// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/progress.h"
#include "line_drawing/object.h"
#include "line_drawing/sheet.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

/// A measured drawing of a mesh: its lines as seen from each of the views, orthographic and at one
/// scale, laid out on paper. `field` is that of the mesh. The same input gives the same sheet on
/// any number of threads.
/// @throws laplacian_lines::Error: InvalidOption, also if the drawing does not fit its paper at its
/// scale; InvalidMesh, EmptyMesh, FieldMismatch, Cancelled.
Sheet makeSheet(const laplacian_lines::TriangleMesh& mesh, const laplacian_lines::Field& field,
                const SheetOptions& options, const laplacian_lines::Progress& progress = {});

/// Several drawings of one scene, for which it is made ready once: of objects in one coordinate
/// system, that hide each other and share bounds and sections. Each has its own lines.
std::vector<Sheet> makeSheets(const Objects& objects, const std::vector<SheetOptions>& options,
                              const laplacian_lines::Progress& progress = {});

/// What can be known of a sheet before its lines are.
struct SheetPlan {
    Eigen::Vector2d paper;  ///< width and height, mm
    double scale;           ///< as Sheet's
};

/// Size and scale of the sheet that these options make of objects, whose fields do not count: in
/// the time that looking at each triangle once takes, for each view.
/// @throws laplacian_lines::Error(InvalidOption) as makeSheets(), but for eyes inside the surface.
SheetPlan planSheet(const Objects& objects, const SheetOptions& options);

}  // namespace line_drawing
