// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/pdf_parts.h"

#include <array>

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

// Thousandths of the height, from code 32 on; 0: no letter.
// clang-format off
constexpr std::array<short, 224> helvetica_widths = {
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584,
    0, 556, 0, 222, 556, 333, 1000, 556, 556, 333, 1000, 667, 333, 1000, 0, 611, 0, 0, 222, 222,
    333, 333, 350, 556, 1000, 333, 1000, 500, 333, 944, 0, 500, 667, 278, 333, 556, 556, 556, 556,
    260, 556, 333, 737, 370, 556, 584, 333, 737, 333, 400, 584, 333, 333, 333, 556, 537, 278, 333,
    333, 365, 556, 834, 834, 834, 611, 667, 667, 667, 667, 667, 667, 1000, 722, 667, 667, 667, 667,
    278, 278, 278, 278, 722, 722, 778, 778, 778, 778, 778, 584, 778, 722, 722, 722, 722, 667, 667,
    611, 556, 556, 556, 556, 556, 556, 889, 500, 556, 556, 556, 556, 278, 278, 278, 278, 556, 556,
    556, 556, 556, 556, 556, 584, 611, 556, 556, 556, 556, 500, 556, 500};
// clang-format on
constexpr char32_t first_code = 32;

/// Codes 0x80 to 0x9f; all others are Unicode's.
constexpr std::u32string_view from_0x80 =
    U"\u20ac\ufffd\u201a\u0192\u201e\u2026\u2020\u2021\u02c6\u2030\u0160\u2039\u0152\ufffd\u017d"
    U"\ufffd\ufffd\u2018\u2019\u201c\u201d\u2022\u2013\u2014\u02dc\u2122\u0161\u203a\u0153\ufffd"
    U"\u017e\u0178";

constexpr char32_t root = U'\u221a', code_of_root = 0xd6;  // in Symbol
constexpr double width_of_root = 0.549;

/// 0 if there is none.
char32_t codeOf(char32_t letter) {
    const std::size_t place = letter == 0xfffd ? from_0x80.npos : from_0x80.find(letter);
    if (place != from_0x80.npos) return char32_t(0x80 + place);
    const bool is_same = letter >= first_code && letter < 0x100 && (letter < 0x7f || letter > 0x9f);
    return is_same ? letter : 0;
}

}  // namespace

StandardText inStandardFonts(const std::string& text) {
    StandardText result;
    for (const char32_t letter : lettersOf(text)) {
        const bool is_root = letter == root;
        const char32_t found = is_root ? code_of_root : codeOf(letter), code = found ? found : '?';
        const StandardFont font = is_root ? StandardFont::Symbol : StandardFont::Helvetica;
        if (result.runs.empty() || result.runs.back().font != font)
            result.runs.push_back({font, {}});
        result.runs.back().codes += char(code);
        result.width += is_root ? width_of_root : helvetica_widths[code - first_code] / 1000.;
        result.is_whole &= found != 0;
    }
    return result;
}

}  // namespace line_drawing
