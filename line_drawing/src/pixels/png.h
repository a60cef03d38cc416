// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "pixels/canvas.h"

namespace line_drawing {

/// A picture as PNG of 256 grays.
std::string inPng(const Canvas& canvas, int dots_per_metre);

}  // namespace line_drawing
