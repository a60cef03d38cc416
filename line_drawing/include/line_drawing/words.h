// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "laplacian_lines/error.h"

namespace line_drawing {

// Texts are UTF-8, case is that of ASCII, numbers are independent of the locale.

using laplacian_lines::refuse;

using Words = std::vector<std::string>;

/// Split at commas, semicolons or spaces.
Words words_of(std::string_view text);
std::string joined(const Words& words, const char* between);

std::string lower(std::string text);
std::string upper(std::string text);
std::string_view trimmed(std::string_view text);
bool ends_with(std::string_view text, std::string_view end);

/// The number in a text that holds nothing else but blanks.
std::optional<double> number_in(std::string_view text);
/// The shortest form with up to so many significant digits: "0.5", "1e+06".
std::string in_digits(double x, int digits = 6);
std::string in_decimals(double x, int decimals);
/// So many thousandths in the shortest form: "-.05" for -50.
std::string thousandths(std::int64_t number);
std::string in_thousandths(double x);  ///< rounded: "-.05" for -0.05
/// A letter in UTF-16, `before` and four digits for each unit: "\u00AB".
std::string in_hexadecimal(char32_t letter, const std::string& before = {});

constexpr char32_t kReplacement = 0xfffd;
/// kReplacement stands for invalid bytes, and for U+FFFE and U+FFFF, which XML forbids.
std::u32string letters_of(std::string_view text);
std::string in_utf8(std::u32string_view letters);
/// Any text without line breaks and other control characters.
std::string one_line(std::string_view text);

}  // namespace line_drawing
