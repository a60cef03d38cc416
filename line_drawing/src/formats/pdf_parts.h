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

/// For PDF's filter LZWDecode: larger than zlib's output, but without a library and with the same
/// bytes everywhere. T. A. Welch, "A Technique for High-Performance Data Compression", Computer
/// (1984), with PDF's codes of 9 to 12 bits, each width one code early.
std::string compressed(const std::string& bytes);

}  // namespace line_drawing
