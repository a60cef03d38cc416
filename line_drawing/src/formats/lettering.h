// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "line_drawing/path.h"
#include "line_drawing/sheet.h"

namespace line_drawing {

/// Outlines of letters of a font that is compiled in (../../letters), as wide as PDF's Helvetica:
/// Latin, Greek, Cyrillic, and signs.
struct Lettering {
    Path path;  ///< of height 1, from (0, 0) on along the base line, y down
    double width = 0;
};

/// Letters that the font lacks are boxes.
Lettering letteringOf(const std::string& text);

/// A text of a sheet as a filled area.
SheetPath outlinesOf(const SheetText& text);

/// The first letter that the font lacks, or nothing.
std::string lackingLetter(const std::string& text);

/// The bytes of ../../letters/letters.ttf; its source is written by CMake.
extern const std::string_view letters_font;

}  // namespace line_drawing
