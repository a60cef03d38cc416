// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/parameters.h"

#include <QColor>
#include <cmath>
#include <limits>
#include <optional>

#include "laplacian_lines/error.h"

namespace meshlab_host {

using laplacian_lines::OptionDescription;
using laplacian_lines::OptionKind;
using laplacian_lines::OptionValue;

namespace {

double asWritten(float value) {
    if (!std::isfinite(value)) return value;
    for (int digits = 6; digits < 9; ++digits) {
        const double decimal = QString::number(double(value), 'g', digits).toDouble();
        if (float(decimal) == value) return decimal;
    }
    return value;
}

/// Empty for types without a number: asking a value for another type trips an assertion in MeshLab.
std::optional<double> number(const Value& value) {
    if (value.isBool()) return value.getBool() ? 1 : 0;
    if (value.isInt()) return value.getInt();
    if (value.isColor()) return value.getColor().rgb() & 0xffffff;
    if (value.isFloat()) return asWritten(float(value.getFloat()));
#if MESHLAB_API < 2022
    if (value.isEnum()) return value.getEnum();
    if (value.isAbsPerc()) return asWritten(value.getAbsPerc());
    if (value.isDynamicFloat()) return asWritten(value.getDynamicFloat());
#endif
    return std::nullopt;
}

struct ParameterText {
    QString name, label, tool_tip;
};

template <class Rich, class... Value>
void add(const ParameterText& text, RichParameterList& list, const Value&... value) {
    list.addParam(Rich(text.name, value..., text.label, text.tool_tip));
}

QString inQt(const std::string& text) {
    return QString::fromStdString(text);
}

Point3m pointOf(const Eigen::Vector3d& p) {
    return {Scalarm(p.x()), Scalarm(p.y()), Scalarm(p.z())};
}

QStringList choicesOf(const OptionDescription& option) {
    QStringList choices;
    for (const char* choice : option.choices)
        choices << choice;
    return choices;
}

QColor colorOf(double value) {
    return QColor(QRgb(value));
}

[[noreturn]] void refuse(const QString& value, const OptionDescription& option) {
    laplacian_lines::refuse_value(QString("\"%1\"").arg(option.label).toStdString(),
                                  value.toStdString(), laplacian_lines::allowed_values(option));
}

double numberOf(const Value& value, const OptionDescription& option) {
    const std::optional<double> result = number(value);
    if (!result || std::isnan(*result)) refuse("not a number", option);
    if (!(*result >= option.minimum && *result <= option.maximum))
        refuse(QString::number(*result), option);
    return *result;
}

std::string textOf(const Value& value, const OptionDescription& option) {
    if (!value.isString()) refuse("not a text", option);
    return value.getString().toStdString();
}

Eigen::Vector3d placeOf(const Value& value, const OptionDescription& option) {
    if (!isPoint(value)) refuse("not a point", option);
    const Point3m p = pointIn(value);
    const Eigen::Vector3d place(asWritten(float(p[0])), asWritten(float(p[1])),
                                asWritten(float(p[2])));
    if (!place.allFinite()) refuse("not finite", option);
    if (option.kind == OptionKind::Direction && place.isZero(0)) refuse("0 0 0", option);
    return place;
}

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

double colorIn(const QString& text) {
    const QColor color(text);
    return color.isValid() ? color.rgb() & 0xffffff : no_value;
}

double realIn(const QString& text) {
    bool is_number = false;
    const double number = text.toDouble(&is_number);
    return is_number ? number : no_value;
}

}  // namespace

QString toolTip(const QString& help) {
    // Qt wraps only rich text.
#if MESHLAB_API < 2022
    // Dialogs also show two lines of it beside the field.
    return "<table width=\"430\"><tr><td>" + help + "</td></tr></table>";
#else
    return "<span>" + help + "</span>";
#endif
}

void addParameter(const OptionDescription& option, const OptionValue& value,
                  RichParameterList& list, double diagonal, const QString& prefix) {
    const ParameterText text{prefix + option.key, option.label, toolTip(option.help)};
    switch (option.kind) {
        case OptionKind::Real:
            return add<RichFloat>(text, list, float(std::get<double>(value)));
        case OptionKind::Length: {
            const double whole = diagonal > 0 ? diagonal : 1;  // the widget divides by it
            return add<RichLength>(text, list, float(std::get<double>(value)), 0.f, float(whole));
        }
        case OptionKind::Boolean:
            return add<RichBool>(text, list, std::get<double>(value) != 0);
        case OptionKind::Choice:
            return add<RichEnum>(text, list, int(std::get<double>(value)), choicesOf(option));
        case OptionKind::Color:
            return add<RichColor>(text, list, colorOf(std::get<double>(value)));
        case OptionKind::Text:
            return add<RichString>(text, list, inQt(std::get<std::string>(value)));
        case OptionKind::File:
            return add<RichFileToSave>(text, list, inQt(std::get<std::string>(value)),
                                       QString("%1 (*.%2)").arg(option.label,
                                                               choicesOf(option).join(" *.")));
        case OptionKind::Position:
            return add<RichPlace>(text, list, pointOf(std::get<Eigen::Vector3d>(value)));
        case OptionKind::Direction:
            return add<RichHeading>(text, list, pointOf(std::get<Eigen::Vector3d>(value)));
    }
}

OptionValue readParameter(const OptionDescription& option, const OptionValue& fallback,
                          const RichParameterList& list, const QString& prefix) {
    const QString name = prefix + option.key;
    if (!list.hasParameter(name)) return fallback;
    const Value& value = list.getParameterByName(name).value();
    switch (option.kind) {
        case OptionKind::Text:
        case OptionKind::File:
            return textOf(value, option);
        case OptionKind::Position:
        case OptionKind::Direction:
            return placeOf(value, option);
        default:
            return numberOf(value, option);
    }
}

double numberIn(const QString& text, const OptionDescription& option) {
    const double value = option.kind == OptionKind::Boolean  ? switchIn(text)
                         : option.kind == OptionKind::Choice ? choiceIn(text, choicesOf(option))
                         : option.kind == OptionKind::Color  ? colorIn(text)
                                                             : realIn(text);
    if (value >= option.minimum && value <= option.maximum) return value;
    const bool has_comma = text.contains(',') && !std::isnan(realIn(QString(text).replace(',', '.')));
    laplacian_lines::refuse_value(
        QString("\"%1\"").arg(option.label).toStdString(), text.toStdString(),
        laplacian_lines::allowed_values(option) + (has_comma ? ", with a decimal point" : ""));
}

QString textOf(double value, const OptionDescription& option) {
    switch (option.kind) {
        case OptionKind::Boolean:
            return value != 0 ? "on" : "off";
        case OptionKind::Choice:
            return option.choices[std::size_t(value)];
        case OptionKind::Color:
            return colorOf(value).name();
        default:
            return QString::number(value, 'g', 9);
    }
}

}  // namespace meshlab_host
