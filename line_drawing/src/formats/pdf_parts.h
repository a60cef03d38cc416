// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace line_drawing {

/// Fonts that every PDF reader has: Helvetica in Windows' code page 1252, and Symbol.
enum class StandardFont { Helvetica, Symbol };

/// A part of a text in one font.
struct FontRun {
    StandardFont font;
    std::string codes;
};

struct StandardText {
    std::vector<FontRun> runs;
    double width = 0;      ///< for a font of height 1
    bool is_whole = true;  ///< no letter is missing, which is a question mark then
};

StandardText inStandardFonts(const std::string& text);

}  // namespace line_drawing
