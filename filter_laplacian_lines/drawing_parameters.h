// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "line_drawing/sheet_choices.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/meshlab_api.h"

/// The user's choices; the filter has a part of line_drawing::sheet_option_table().
using DrawingParameters = line_drawing::SheetChoices;

/// The file is beside the mesh's; with a window its view and the likely unit. Scripts have the same
/// everywhere.
DrawingParameters drawing_defaults(const MeshModel* mesh, bool has_window);

void list_drawing_parameters(const DrawingParameters& defaults, RichParameterList& list);

/// @throws laplacian_lines::Error(InvalidOption) that names a parameter out of range
DrawingParameters read_drawing_parameters(const RichParameterList& list);

// Placeholders in the file's name: {folder} and {name}.

std::string file_for(const MeshModel& mesh, const std::string& file);
/// For scripts: with these placeholders, and the window's view as text.
DrawingParameters for_any_mesh(DrawingParameters chosen, const MeshModel& mesh,
                               const meshlab_host::CurrentView& window);

/// Views are in world coordinates, `window` is the window's current one.
/// @throws laplacian_lines::Error(InvalidOption) with what is understood, also if there is no view
/// of a window or decoration to follow
line_drawing::SheetOptions sheet_options(const DrawingParameters& chosen,
                                         const std::optional<meshlab_host::CurrentView>& window);
