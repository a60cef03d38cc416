// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "decoration_parameters.h"
#include "meshlab_host/parameter_panel.h"

/// How the panel in the layer dialog shows the parameters: those of the first hour on its first
/// screen, all others when they are asked for, and switched off what has no effect on what is
/// chosen, above all what a drawing style overrides. What is out of range can always be mended.
std::vector<meshlab_host::PanelLine> panelLines(const ValidParameters& parameters);
