// SPDX-License-Identifier: GPL-3.0-or-later
#include "number_validator.h"

namespace meshlab_host {
namespace {

bool isNumber(const QString& text) {
    bool is_number = false;
    text.toDouble(&is_number);
    return is_number;
}

}  // namespace

QValidator::State NumberValidator::validate(QString& text, int&) const {
    return isNumber(text) ? Acceptable : Intermediate;
}

void NumberValidator::fixup(QString& text) const {
    QString number = text.trimmed();
    if (number.count(',') == 1 && !number.contains('.')) number.replace(',', '.');
    text = isNumber(number) ? number : "nan";
}

}  // namespace meshlab_host
