// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "laplacian_lines/error.h"

namespace line_drawing {

// Texts are UTF-8; upper and lower case are those of ASCII, and numbers are the same in any locale.

using laplacian_lines::refuse;

using Words = std::vector<std::string>;

/// Those of a list whose words are separated by commas, semicolons or spaces.
Words wordsOf(std::string_view text);
std::string joined(const Words& words, const char* between);

std::string lower(std::string text);
std::string upper(std::string text);
std::string_view trimmed(std::string_view text);
bool endsWith(std::string_view text, std::string_view end);

/// Of a text that is a number and nothing else, blanks around it apart.
std::optional<double> numberIn(std::string_view text);
/// As short as so many significant digits can be written: "0.5", "1e+06".
std::string inDigits(double x, int digits = 6);
std::string inDecimals(double x, int decimals);
/// So many thousandths, as short as they can be written: "-.05".
std::string thousandths(std::int64_t number);
std::string inThousandths(double x);
/// Of four digits: "00AB".
std::string inHexadecimal(char32_t number);

/// The characters of a text; U+FFFD for what is none.
std::u32string lettersOf(std::string_view text);
std::string inUtf8(std::u32string_view letters);
/// A text that may hold anything, made to fit a line: no line breaks or other control characters.
std::string oneLine(std::string_view text);

}  // namespace line_drawing
