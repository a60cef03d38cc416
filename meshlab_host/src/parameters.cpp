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

constexpr int kDigits = std::numeric_limits<float>::max_digits10;  // tell all floats apart

/// Of floats the shortest decimal; others, which only Python has, stay.
double as_written(double value) {
    if (!std::isfinite(value) || double(float(value)) != value) return value;
    double decimal = value;
    for (int digits = std::numeric_limits<float>::digits10; digits <= kDigits; ++digits) {
        decimal = QString::number(value, 'g', digits).toDouble();
        if (float(decimal) == float(value)) break;
    }
    return decimal;
}

/// Empty for types without a number: asking a value for another type trips an assertion in MeshLab.
std::optional<double> as_number(const Value& value) {
    if (value.isBool()) return value.getBool() ? 1 : 0;
    if (value.isInt()) return value.getInt();
    if (value.isColor()) return value.getColor().rgb() & 0xffffff;
    if (value.isFloat()) return as_written(value.getFloat());
#if MESHLAB_API < 2022
    if (value.isEnum()) return value.getEnum();
    if (value.isAbsPerc()) return as_written(value.getAbsPerc());
    if (value.isDynamicFloat()) return as_written(value.getDynamicFloat());
#endif
    return std::nullopt;
}

struct ParameterText {
    QString name, label, tool_tip;
};

template <class Rich, class... Values>
void add(const ParameterText& text, RichParameterList& list, const Values&... values) {
    list.addParam(Rich(text.name, values..., text.label, text.tool_tip));
}

QStringList choices_of(const OptionDescription& option) {
    QStringList choices;
    for (const char* choice : option.choices)
        choices << choice;
    return choices;
}

bool is_real(const OptionDescription& option) {
    return option.kind == OptionKind::Real || option.kind == OptionKind::Length;
}

double checked_number(const Value& value, const OptionDescription& option) {
    const std::optional<double> result = as_number(value);
    if (!result || std::isnan(*result)) refuse_value(option, "not a number");
    if (!(*result >= option.minimum && *result <= option.maximum) ||
        (!is_real(option) && *result != std::floor(*result)))
        refuse_value(option, QString::number(*result, 'g', kDigits).toStdString());
    return *result;
}

Eigen::Vector3d checked_point(const Value& value, const OptionDescription& option) {
    if (!is_point(value)) refuse_value(option, "not a point");
    const Point3m p = point_in(value);
    const Eigen::Vector3d point(as_written(p[0]), as_written(p[1]), as_written(p[2]));
    if (!point.allFinite()) refuse_value(option, "not finite");
    if (option.kind == OptionKind::Direction && point.isZero(0)) refuse_value(option, "0 0 0");
    return point;
}

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

double switch_in(const QString& text) {
    if (QStringList{"on", "yes", "true", "1"}.contains(text, Qt::CaseInsensitive)) return 1;
    if (QStringList{"off", "no", "false", "0"}.contains(text, Qt::CaseInsensitive)) return 0;
    return kNoValue;
}

double choice_in(const QString& text, const QStringList& choices) {
    bool is_number = false;
    const int number = text.toInt(&is_number);
    if (is_number) return number;
    double found = kNoValue;
    for (int i = 0; i < choices.size(); ++i) {
        if (choices[i].compare(text, Qt::CaseInsensitive) == 0) return i;
        if (text.isEmpty() || !choices[i].startsWith(text, Qt::CaseInsensitive)) continue;
        if (!std::isnan(found)) return kNoValue;
        found = i;
    }
    return found;
}

double color_in(const QString& text) {
    const QColor color(text);
    return color.isValid() && color.alpha() == 255 ? color.rgb() & 0xffffff : kNoValue;
}

double real_in(const QString& text) {
    bool is_number = false;
    const double number = text.toDouble(&is_number);
    return is_number ? number : kNoValue;
}

}  // namespace

QString tool_tip(const QString& help) {
    // Qt wraps only rich text.
#if MESHLAB_API < 2022
    // Dialogs also show two lines of it beside the field.
    return "<table width=\"430\"><tr><td>" + help + "</td></tr></table>";
#else
    return "<span>" + help + "</span>";
#endif
}

void add_parameter(const OptionDescription& option, const OptionValue& value,
                   RichParameterList& list, double diagonal, const QString& prefix) {
    const ParameterText text{prefix + option.key, option.label, tool_tip(option.help)};
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
            return add<RichEnum>(text, list, int(std::get<double>(value)), choices_of(option));
        case OptionKind::Color:
            return add<RichColor>(text, list, QColor(QRgb(std::get<double>(value))));
        case OptionKind::Text:
            return add<RichString>(text, list,
                                   QString::fromStdString(std::get<std::string>(value)));
        case OptionKind::File:
            return add<RichFileToSave>(
                text, list, QString::fromStdString(std::get<std::string>(value)),
                QString("%1 (*.%2)").arg(option.label, choices_of(option).join(" *.")));
        case OptionKind::Position:
            return add<RichPlace>(text, list, point_of(std::get<Eigen::Vector3d>(value)));
        case OptionKind::Direction:
            return add<RichHeading>(text, list, point_of(std::get<Eigen::Vector3d>(value)));
    }
}

OptionValue read_parameter(const OptionDescription& option, const OptionValue& fallback,
                           const RichParameterList& list, const QString& prefix) {
    const QString name = prefix + option.key;
    if (!list.hasParameter(name)) return fallback;
    const Value& value = list.getParameterByName(name).value();
    switch (option.kind) {
        case OptionKind::Text:
        case OptionKind::File:
            if (!value.isString()) refuse_value(option, "not a text");
            return value.getString().toStdString();
        case OptionKind::Position:
        case OptionKind::Direction:
            return checked_point(value, option);
        default:
            return checked_number(value, option);
    }
}

double number_in(const QString& text, const OptionDescription& option) {
    const double value = option.kind == OptionKind::Boolean  ? switch_in(text)
                         : option.kind == OptionKind::Choice ? choice_in(text, choices_of(option))
                         : option.kind == OptionKind::Color  ? color_in(text)
                                                             : real_in(text);
    if (value >= option.minimum && value <= option.maximum) return value;
    const bool has_comma = is_real(option) && text.contains(',') &&
                           !std::isnan(real_in(QString(text).replace(',', '.')));
    refuse_value(option, text.toStdString(), has_comma ? ", with a decimal point" : "");
}

QString text_of(double value, const OptionDescription& option) {
    switch (option.kind) {
        case OptionKind::Boolean:
            return value != 0 ? "on" : "off";
        case OptionKind::Choice:
            return option.choices[std::size_t(value)];
        case OptionKind::Color:
            return QColor(QRgb(value)).name();
        default:
            return QString::number(value, 'g', kDigits);
    }
}

}  // namespace meshlab_host
