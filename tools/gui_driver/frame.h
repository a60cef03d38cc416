// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace driver {

struct Command;

// frame AZIMUTH ELEVATION [UP [ZOOM [orthographic]]]: has the surfaces of all layers fill the view
// up to a margin, as seen from there. The place of the camera is computed from the vertices: the
// view need not be drawn. ZOOM enlarges the picture about its middle.
void frame(const Command& command);

// write-kernel FILE: the kernel size of the current layer, as the decoration has it by default, in
// pixels of the latest frame.
void writeKernel(const Command& command);

}  // namespace driver
