// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace line_drawing {
namespace {

constexpr std::string_view kBlanks = " \t\n\v\f\r";

template <class Change>
std::string changed(std::string text, char first, char last, Change change) {
    for (char& c : text)
        if (c >= first && c <= last) c = change(c);
    return text;
}

/// Length in bytes of the UTF-8 character that begins with this byte; 0: none does.
std::size_t length_by_first(unsigned char byte) {
    if (byte < 0x80) return 1;
    return byte >= 0xf5 || byte < 0xc2 ? 0 : byte >= 0xf0 ? 4 : byte >= 0xe0 ? 3 : 2;
}

/// Removes the first character of a text.
char32_t take_letter(std::string_view& text) {
    constexpr std::array<char32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t length = length_by_first(byte(0));
    char32_t letter = length == 1 ? byte(0) : byte(0) & (0x7fu >> length);
    std::size_t i = 1;
    for (; i < length && i < text.size() && (byte(i) & 0xc0) == 0x80; ++i)
        letter = letter << 6 | (byte(i) & 0x3f);
    const bool is_whole = length > 0 && i == length && letter >= least[length] &&
                          letter <= 0x10ffff && (letter < 0xd800 || letter > 0xdfff) &&
                          letter != 0xfffe && letter != 0xffff;
    text.remove_prefix(is_whole ? length : 1);
    return is_whole ? letter : kReplacement;
}

std::string written(double x, std::chars_format format, int precision) {
    std::array<char, 400> digits;  // the largest number has 309 before its point
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), x, format, precision);
    return {digits.data(), end.ptr};
}

}  // namespace

Words words_of(std::string_view text) {
    constexpr std::string_view between = ",; \t\n\v\f\r";
    Words words;
    for (std::size_t begin = 0; (begin = text.find_first_not_of(between, begin)) != text.npos;) {
        const std::size_t end = std::min(text.find_first_of(between, begin), text.size());
        words.emplace_back(text.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

std::string joined(const Words& words, const char* between) {
    std::string text;
    for (const std::string& word : words)
        text += (&word == words.data() ? "" : between) + word;
    return text;
}

std::string lower(std::string text) {
    return changed(std::move(text), 'A', 'Z', [](char c) { return char(c - 'A' + 'a'); });
}
std::string upper(std::string text) {
    return changed(std::move(text), 'a', 'z', [](char c) { return char(c - 'a' + 'A'); });
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
    return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

bool ends_with(std::string_view text, std::string_view end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

std::optional<double> number_in(std::string_view text) {
    text = trimmed(text);
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (text.empty() || error != std::errc() || end != text.data() + text.size()) return {};
    return number;
}

std::string in_digits(double x, int digits) {
    return written(x, std::chars_format::general, digits);
}
std::string in_decimals(double x, int decimals) {
    return written(x, std::chars_format::fixed, decimals);
}

std::string thousandths(std::int64_t number) {
    std::string digits = std::to_string(std::abs(number));
    digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
    digits.insert(digits.size() - 3, ".");
    while (digits.back() == '0')
        digits.pop_back();
    if (digits.back() == '.') digits.pop_back();
    if (digits.size() > 1 && digits[0] == '0') digits.erase(0, 1);
    return number < 0 ? '-' + digits : digits;
}
std::string in_thousandths(double x) {
    return thousandths(std::llround(1000 * x));
}

std::string in_hexadecimal(char32_t letter, const std::string& before) {
    if (letter >= 0x10000)
        return in_hexadecimal(0xd7c0 + (letter >> 10), before) +
               in_hexadecimal(0xdc00 + (letter & 0x3ff), before);
    std::string digits = before;
    for (int shift = 12; shift >= 0; shift -= 4)
        digits += "0123456789ABCDEF"[letter >> shift & 15];
    return digits;
}

std::u32string letters_of(std::string_view text) {
    std::u32string letters;
    while (!text.empty())
        letters += take_letter(text);
    return letters;
}

std::string in_utf8(std::u32string_view letters) {
    std::string text;
    for (const char32_t c : letters) {
        const int more = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
        constexpr std::array<unsigned, 4> marks = {0, 0xc0, 0xe0, 0xf0};
        text += char(marks[std::size_t(more)] | c >> 6 * more);
        for (int i = more; i-- > 0;)
            text += char(0x80 | (c >> 6 * i & 0x3f));
    }
    return text;
}

std::string one_line(std::string_view text) {
    std::u32string letters = letters_of(text);
    for (char32_t& c : letters)
        if (c < ' ' || (c >= 0x7f && c < 0xa0) || c == 0x2028 || c == 0x2029) c = ' ';
    return in_utf8(letters);
}

}  // namespace line_drawing
