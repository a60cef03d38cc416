// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_options.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

constexpr double largest_scale = 1e9;  // and one in as many

/// By what it is the unit of, mm.
struct LengthUnit {
    const char* name;
    double mm, below;
};
constexpr LengthUnit length_units[] = {
    {" µm", 1e-3, 0.1}, {" mm", 1, 1e4}, {" m", 1e3, 1e7}, {" km", 1e6, 0}};

std::string rounded(double x) {
    if (x < 0.0995) return inDigits(std::round(1000 * x) / 1000);
    return inDecimals(x, x < 10 ? 2 : x < 1000 ? 1 : 0);
}

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
    constexpr int digits = 9;
    return scale < 1 ? "1:" + inDigits(1 / scale, digits) : inDigits(scale, digits) + ":1";
}

std::string sizeInWords(const Eigen::Vector3d& mm, const char* times) {
    const double longest = mm.maxCoeff() > 0 ? mm.maxCoeff() : 1;
    const LengthUnit* unit = length_units;
    while (unit + 1 != std::end(length_units) && longest >= unit->below)
        ++unit;
    Words sides;
    for (int axis = 0; axis < 3; ++axis)
        sides.push_back(rounded(mm[axis] / unit->mm));
    return joined(sides, times) + unit->name;
}

std::string kernelInWords(double mm) {
    return mm < 100 ? inDigits(mm, 2) : inDecimals(mm, 0);
}

}  // namespace line_drawing
