// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/parameters.h"

#include <cmath>
#include <limits>

#include "laplacian_lines/error.h"

namespace meshlab_host {

using laplacian_lines::OptionKind;

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

double switchIn(const QString& text) {
    if (QStringList{"on", "yes", "true", "1"}.contains(text, Qt::CaseInsensitive)) return 1;
    if (QStringList{"off", "no", "false", "0"}.contains(text, Qt::CaseInsensitive)) return 0;
    return no_value;
}

double choiceIn(const QString& text, const QStringList& choices) {
    bool is_number = false;
    const int number = text.toInt(&is_number);
    if (is_number) return number;
    double found = no_value;
    for (int i = 0; i < choices.size(); ++i) {
        if (choices[i].compare(text, Qt::CaseInsensitive) == 0) return i;
        if (text.isEmpty() || !choices[i].startsWith(text, Qt::CaseInsensitive)) continue;
        if (!std::isnan(found)) return no_value;
        found = i;
    }
    return found;
}

double numberIn(const QString& text) {
    bool is_number = false;
    const double number = text.toDouble(&is_number);
    return is_number ? number : no_value;
}

}  // namespace

double valueIn(const QString& text, const ParameterDescription& d) {
    double value = no_value;
    switch (d.kind) {
        case OptionKind::Boolean:
            value = switchIn(text);
            break;
        case OptionKind::Choice:
            value = choiceIn(text, d.choices);
            break;
        case OptionKind::Real:
        case OptionKind::Length:
            value = numberIn(text);
            break;
    }
    if (value >= d.minimum && value <= d.maximum) return value;
    const bool has_comma = !std::isnan(numberIn(QString(text).replace(',', '.')));
    const QString hint = has_comma && text.contains(',') ? ", with a decimal point" : "";
    refuseValue(text, d.label, d.allowed + hint);
}

QString textOf(double value, const ParameterDescription& d) {
    if (d.kind == OptionKind::Boolean) return value != 0 ? "on" : "off";
    if (d.kind == OptionKind::Choice) return d.choices.value(int(value));
    return QString::number(value, 'g', 9);
}

void refuseValue(const QString& value, const ParameterDescription& d) {
    refuseValue(value, d.label, d.allowed);
}

void refuseValue(const QString& value, const QString& label, const QString& allowed) {
    laplacian_lines::refuse_value(QString("\"%1\"").arg(label).toStdString(), value.toStdString(),
                                  allowed.toStdString());
}

}  // namespace meshlab_host
