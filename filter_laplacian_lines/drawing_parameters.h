// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "line_drawing/sheet_choices.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/meshlab_api.h"

/// The user's choices; the filter has a part of line_drawing::sheet_option_table().
using DrawingParameters = line_drawing::SheetChoices;

/// The file lies beside the mesh's. With a window: its view, and the likely unit; without, these
/// are the same for every mesh.
DrawingParameters drawing_defaults(const MeshModel* mesh, bool has_window);

void list_drawing_parameters(const DrawingParameters& defaults, RichParameterList& list);

/// @throws laplacian_lines::Error(InvalidOption) that names a parameter out of range
DrawingParameters read_drawing_parameters(const RichParameterList& list);

// In a drawing's file, {folder} and {name} stand for the folder of the mesh's file, and its name
// without the ending.

/// With the placeholders replaced.
std::string file_for(const MeshModel& mesh, const std::string& file);
/// For scripts: with these placeholders, and the window's view as text.
DrawingParameters for_any_mesh(DrawingParameters chosen, const MeshModel& mesh,
                               const meshlab_host::CurrentView& window);

/// Views are in world coordinates, `window` is the window's current one.
/// @throws laplacian_lines::Error(InvalidOption) with what is understood, also if there is no view
/// of a window or decoration to follow
line_drawing::SheetOptions sheet_options(const DrawingParameters& chosen,
                                         const std::optional<meshlab_host::CurrentView>& window);
