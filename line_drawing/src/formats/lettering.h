// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "line_drawing/path.h"

namespace line_drawing {

/// Outlines of letters of a font that is compiled in (../../letters), as wide as PDF's Helvetica:
/// Latin, Greek, Cyrillic, and signs.
struct Lettering {
    Path path;  ///< of height 1, from (0, 0) on along the base line, y down
    double width = 0;
};

/// @throws laplacian_lines::Error(InvalidOption) if the font lacks a letter, with what to do
/// instead.
Lettering letteringOf(const std::string& text);

}  // namespace line_drawing
