// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace line_drawing {

/// Those that every reader of PDF has: Helvetica by Windows' code page 1252, and Symbol.
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

/// Compressed as PDF's filter LZWDecode reads it: less well than zlib does, but without a library,
/// and with the same bytes everywhere.
///
/// Source: T. A. Welch, "A Technique for High-Performance Data Compression", Computer (1984), with
/// the codes of PDF: 9 to 12 bits, each width from one code before it is needed.
std::string compressed(const std::string& bytes);

}  // namespace line_drawing
