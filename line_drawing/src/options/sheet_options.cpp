// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_options.h"

#include <algorithm>

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

constexpr double largest_scale = 1e9;  // and one in as many

}  // namespace

double parseScale(std::string_view text) {
    if (lower(std::string(trimmed(text))) == "fit") return 0;
    const std::size_t colon = std::min(text.find(':'), text.size());
    const double drawn = numberIn(text.substr(0, colon)).value_or(0);
    const double real = numberIn(text.substr(std::min(colon + 1, text.size()))).value_or(0);
    const double scale = drawn / real;
    if (!(drawn > 0) || !(real > 0) || !(scale >= 1 / largest_scale && scale <= largest_scale))
        refuse(
            "\"" + std::string(text) +
            "\" is not a scale. A scale is drawn to true length, such as 1:2 or 2:1, or fit: the "
            "largest usual one.");
    return scale;
}

DetailSize parseDetailSize(std::string_view text) {
    const std::string word = lower(std::string(trimmed(text)));
    if (word == "auto") return {};
    const bool is_share = endsWith(word, "%");
    const std::size_t unit = is_share ? 1 : endsWith(word, "mm") ? 2 : 0;
    const double size = numberIn(word.substr(0, word.size() - unit)).value_or(0);
    if (unit == 0 || !(size >= 1e-3 && size <= 100))
        refuse("\"" + std::string(text) +
               "\" is not a size of detail. Say auto, a length on paper such as 1mm, or a share of "
               "the object's diagonal such as 0.9%.");
    return {is_share ? size / 100 : size, is_share};
}

std::string scaleInWords(double scale) {
    return scale < 1 ? "1:" + inDigits(1 / scale) : inDigits(scale) + ":1";
}

}  // namespace line_drawing
