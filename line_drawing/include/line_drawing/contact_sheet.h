// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/sheet.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

/// Options for one mesh of a contact sheet: its first view, small, no furniture; the title is its
/// size.
SheetOptions contactOptions(const laplacian_lines::TriangleMesh& mesh, const SheetOptions& options);

struct ContactEntry {
    std::string name;
    Sheet view;
};

/// One page with all views in equal squares, name and size below each.
Sheet makeContactSheet(const std::vector<ContactEntry>& entries, const std::string& title);

/// Serializes the paths of a sheet.
std::string packSheet(const Sheet& sheet);
/// @throws laplacian_lines::Error(InvalidOption) if the bytes are no packed sheet
Sheet unpackSheet(const std::string& bytes);

}  // namespace line_drawing
