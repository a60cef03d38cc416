// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "drawing_parameters.h"
#include "line_drawing/sheet_options.h"
#include "meshlab_host/current_view.h"

/// What is to be drawn, views in world coordinates. `window` is the current view of the window.
/// @throws laplacian_lines::Error(InvalidOption) with what is understood, also if the view of the
/// window or the decoration's settings are asked for where there are none.
line_drawing::SheetOptions sheetOptions(const DrawingParameters& chosen,
                                        const std::optional<meshlab_host::CurrentView>& window);
