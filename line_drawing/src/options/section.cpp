// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/section.h"

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

constexpr std::string_view axes = "xyz";

Section parse(const std::string& word) {
    const std::size_t axis = axes.find(lower(word)[0]);
    const double share =
        word.size() > 2 && word[1] == '=' ? numberIn(word.substr(2)).value_or(0) : 0;
    if (axis == axes.npos || !(share > 0 && share < 1))
        refuse("\"" + word +
               "\" is not a section. A section is an axis and a place on it, 0 to 1 of the object, "
               "such as y=0.5.");
    return {int(axis), share};
}

}  // namespace

std::vector<Section> parseSections(std::string_view text) {
    std::vector<Section> sections;
    for (const std::string& word : wordsOf(text))
        sections.push_back(parse(word));
    return sections;
}

std::string letterOf(std::size_t number) {
    constexpr std::size_t letters = 26;
    const std::string last(1, char('A' + number % letters));
    return number < letters ? last : letterOf(number / letters - 1) + last;
}

ViewFrame frameOfSection(const Section& section, UpAxis up) {
    ViewFrame frame;
    for (const Side side : {Side::Top, Side::Front, Side::Left}) {
        frame = frameOfSide(side, up);
        if (frame.towards_viewer[section.axis] != 0) break;
    }
    frame.side = Side::Other;
    frame.name = std::string("Section ") + axes[std::size_t(section.axis)] + " = " +
                 inDigits(100 * section.share, 3) + " %";
    return frame;
}

}  // namespace line_drawing
