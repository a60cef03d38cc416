// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_options.h"

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

constexpr double largest_scale = 1e9;  // and one in as many

}  // namespace

double parseScale(const QString& text) {
    if (text.trimmed().compare("fit", Qt::CaseInsensitive) == 0) return 0;
    const QStringList parts = text.split(':');
    bool is_number = parts.size() == 2, is_other = is_number;
    const double drawn = is_number ? parts[0].toDouble(&is_number) : 0;
    const double real = is_other ? parts[1].toDouble(&is_other) : 0;
    const double scale = drawn / real;
    if (!is_number || !is_other || !(drawn > 0) || !(real > 0) ||
        !(scale >= 1 / largest_scale && scale <= largest_scale))
        refuse(QString(
                   "\"%1\" is not a scale. A scale is drawn to true length, such as 1:2 or 2:1, or "
                   "fit: the largest usual one.")
                   .arg(text));
    return scale;
}

DetailSize parseDetailSize(const QString& text) {
    const QString word = text.trimmed().toLower();
    if (word == "auto") return {};
    const bool is_share = word.endsWith('%'), is_length = word.endsWith("mm");
    bool is_number = false;
    const double size = word.chopped(is_share ? 1 : is_length ? 2 : 0).toDouble(&is_number);
    if (!is_number || !(is_share || is_length) || !(size >= 1e-3 && size <= 100))
        refuse(
            QString("\"%1\" is not a size of detail. Say auto, a length on paper such as 1mm, or a "
                    "share of the object's diagonal such as 0.9%.")
                .arg(text));
    return {is_share ? size / 100 : size, is_share};
}

QString scaleInWords(double scale) {
    const auto number = [](double x) { return QString::number(x, 'g', 6); };
    return scale < 1 ? "1:" + number(1 / scale) : number(scale) + ":1";
}

}  // namespace line_drawing
