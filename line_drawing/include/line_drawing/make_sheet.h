// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/object.h"
#include "line_drawing/sheet.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

/// Measured drawings of one scene, which is prepared once: all views orthographic (or in
/// perspective) at one scale, laid out on paper, a sheet for each of `options`. Its objects hide
/// each other and share a coordinate system, bounds and sections; each has its own lines. Any
/// number of threads gives the same sheets.
/// @throws laplacian_lines::Error: InvalidOption, also if a drawing does not fit its paper at its
/// scale; InvalidMesh, EmptyMesh, FieldMismatch, Cancelled.
std::vector<Sheet> make_sheets(const Objects& objects, const std::vector<SheetOptions>& options,
                               const laplacian_lines::Progress& progress = {});

/// Puts areas of the shape of letters in place of all texts.
void outline_texts(Sheet& sheet);

/// Options for one mesh of a contact sheet: its first view, small, without perspective and
/// annotations; the title is its size.
SheetOptions contact_options(const laplacian_lines::TriangleMesh& mesh,
                             const SheetOptions& options);

struct ContactEntry {
    std::string name;
    Sheet view;  ///< drawn with contact_options()
};

/// One page with all views in equal squares, name and size below each.
Sheet make_contact_sheet(const std::vector<ContactEntry>& entries, const std::string& title);

}  // namespace line_drawing
