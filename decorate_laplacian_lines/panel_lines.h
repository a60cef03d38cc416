// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "decoration_parameters.h"
#include "meshlab_host/parameter_panel.h"

/// The layer dialog's panel: parameters of the first hour on the first screen, others on request,
/// and disabled what has no effect, above all what a drawing style overrides. Errors can always be
/// mended.
std::vector<meshlab_host::PanelLine> panelLines(const ValidParameters& parameters);
