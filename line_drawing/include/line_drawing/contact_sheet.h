// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/sheet.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

/// How a mesh is drawn for a contact sheet: its first view, small and without furniture; the
/// title is its size.
SheetOptions contactOptions(const laplacian_lines::TriangleMesh& mesh, const SheetOptions& options);

struct ContactEntry {
    std::string name;
    Sheet view;
};

/// One page with all views, each in a square of the same size, with name and size below.
Sheet makeContactSheet(const std::vector<ContactEntry>& entries, const std::string& title);

/// The paths of a sheet as bytes, to be kept in a file.
std::string packSheet(const Sheet& sheet);
/// @throws laplacian_lines::Error(InvalidOption) if it is none.
Sheet unpackSheet(const std::string& bytes);

}  // namespace line_drawing
