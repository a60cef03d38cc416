// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "line_drawing/path.h"
#include "line_drawing/sheet.h"

namespace line_drawing {

// By the compiled-in font (../../letters), which has Helvetica's widths but for a few signs: Latin,
// Greek, Cyrillic, and signs. Letters that it lacks are drawn by others that look alike, such as Ø
// for ⌀, or become boxes.

/// In heights of the font.
double width_of(char32_t letter);
double width_of(const std::string& text);

/// The text as an area, on the sheet.
SheetPath outlines_of(const SheetText& text);

/// The first letter that would become a box, or an empty string.
std::string missing_letter(const std::string& text);

/// ../../letters/letters.ttf; CMake writes its source.
extern const std::string_view kLettersFont;

}  // namespace line_drawing
