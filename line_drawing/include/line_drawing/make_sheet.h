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

}  // namespace line_drawing
