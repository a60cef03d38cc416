// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "line_drawing/path.h"
#include "line_drawing/sheet.h"

namespace line_drawing {

// By the compiled-in font (../../letters), which has Helvetica's widths: Latin, Greek, Cyrillic,
// and signs. Letters that it lacks are drawn by others that look alike, such as Ø for ⌀, or become
// boxes.

/// For a font of height 1.
double widthOf(char32_t letter);
double widthOf(const std::string& text);

SheetPath outlinesOf(const SheetText& text);

/// The first letter that would become a box, or nothing.
std::string lackingLetter(const std::string& text);

/// ../../letters/letters.ttf; CMake writes its source.
extern const std::string_view letters_font;

}  // namespace line_drawing
