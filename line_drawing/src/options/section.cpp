// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/section.h"

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

Section parse(const QString& word) {
    const QStringList parts = word.split('=');
    const int axis =
        parts.size() == 2 && parts[0].size() == 1 ? QString("xyz").indexOf(parts[0].toLower()) : -1;
    bool is_number = axis >= 0;
    const double share = is_number ? parts[1].toDouble(&is_number) : 0;
    if (!is_number || !(share > 0 && share < 1))
        refuse(QString(
                   "\"%1\" is not a section. A section is an axis and a place on it, 0 to 1 of the "
                   "object, such as y=0.5.")
                   .arg(word));
    return {axis, share};
}

}  // namespace

std::vector<Section> parseSections(const QString& text) {
    std::vector<Section> sections;
    for (const QString& word : wordsOf(text))
        sections.push_back(parse(word));
    return sections;
}

QString letterOf(std::size_t number) {
    constexpr std::size_t letters = 26;
    const QString last(QChar(ushort('A' + number % letters)));
    return number < letters ? last : letterOf(number / letters - 1) + last;
}

ViewFrame frameOfSection(const Section& section, UpAxis up) {
    ViewFrame frame;
    for (const Side side : {Side::Top, Side::Front, Side::Left}) {
        frame = frameOfSide(side, up);
        if (frame.towards_viewer[section.axis] != 0) break;
    }
    frame.side = Side::Other;
    frame.name =
        QString("Section %1 = %2 %").arg(QString("xyz")[section.axis]).arg(100 * section.share);
    return frame;
}

}  // namespace line_drawing
