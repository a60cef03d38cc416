// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_options.h"

#include "options/words.h"

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
        refuse(
            QString("\"%1\" is no scale. A scale is drawn to true length, such as 1:2 or 2:1, or "
                    "fit: the largest usual one.")
                .arg(text));
    return scale;
}

QString scaleInWords(double scale) {
    const auto number = [](double x) { return QString::number(x, 'g', 6); };
    return scale < 1 ? "1:" + number(1 / scale) : number(scale) + ":1";
}

}  // namespace line_drawing
