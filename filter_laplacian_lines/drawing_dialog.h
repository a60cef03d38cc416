// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drawing_parameters.h"
#include "meshlab_host/filter_dialog.h"

/// Adds to the dialog of the filter what MeshLab's parameters have not: check marks for views, a
/// button that looks for the file, size and scale before anything is drawn, and what it was last
/// applied with. `defaults` is what the dialog was opened with.
void furnishDrawingDialog(meshlab_host::FilterDialog dialog, const DrawingParameters& defaults,
                          const MeshDocument& document);
