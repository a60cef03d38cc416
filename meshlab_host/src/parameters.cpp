// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/parameters.h"

#include <cmath>
#include <limits>

#include "laplacian_lines/error.h"

namespace meshlab_host {

using laplacian_lines::OptionKind;

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
    if (value.isFloat()) return asWritten(float(value.getFloat()));
#if MESHLAB_API < 2022
    if (value.isEnum()) return value.getEnum();
    if (value.isAbsPerc()) return asWritten(value.getAbsPerc());
    if (value.isDynamicFloat()) return asWritten(value.getDynamicFloat());
#endif
    return std::nullopt;
}

template <class Rich, class Description, class... Value>
void add(const Description& d, RichParameterList& list, const Value&... value) {
    list.addParam(Rich(d.name, value..., d.label, toolTip(d.help)));
}

[[noreturn]] void refuseValue(const QString& value, const ParameterDescription& d) {
    meshlab_host::refuseValue(value, d.label, d.allowed);
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

double numberIn(const QString& text) {
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

void addNumber(const ParameterDescription& d, double value, double diagonal,
               RichParameterList& list) {
    switch (d.kind) {
        case OptionKind::Real:
            return add<RichFloat>(d, list, float(value));
        case OptionKind::Length: {
            const double whole = diagonal > 0 ? diagonal : 1;  // the widget divides by it
            return add<RichLength>(d, list, float(value), 0.f, float(whole));
        }
        case OptionKind::Boolean:
            return add<RichBool>(d, list, value != 0);
        case OptionKind::Choice:
            return add<RichEnum>(d, list, int(value), d.choices);
    }
}

double readNumber(const ParameterDescription& d, double fallback, const RichParameterList& list) {
    if (!list.hasParameter(d.name)) return fallback;
    const std::optional<double> value = number(list.getParameterByName(d.name).value());
    if (!value) refuseValue("not a number", d);
    // NaN fails, too.
    if (!(*value >= d.minimum && *value <= d.maximum))
        refuseValue(std::isnan(*value) ? "not a number" : QString::number(*value), d);
    return *value;
}

void addPlace(const PlaceDescription& d, const Eigen::Vector3d& value, RichParameterList& list) {
    const Point3m point(Scalarm(value.x()), Scalarm(value.y()), Scalarm(value.z()));
    if (d.kind == PlaceKind::Position)
        add<RichPlace>(d, list, point);
    else
        add<RichHeading>(d, list, point);
}

Eigen::Vector3d readPlace(const PlaceDescription& d, const Eigen::Vector3d& fallback,
                          const RichParameterList& list) {
    if (!list.hasParameter(d.name)) return fallback;
    const Value& value = list.getParameterByName(d.name).value();
    const auto refuse = [&](const char* why) {
        laplacian_lines::refuse(QString("\"%1\" %2").arg(d.label, why).toStdString());
    };
    if (!isPoint(value)) refuse("has to be three numbers.");
    const Point3m point = pointIn(value);
    const Eigen::Vector3d result(asWritten(float(point[0])), asWritten(float(point[1])),
                                 asWritten(float(point[2])));
    if (!result.allFinite()) refuse("has to be three finite numbers.");
    if (d.kind == PlaceKind::Direction && result.isZero(0))
        refuse("is 0 0 0, which is not a direction.");
    return result;
}

void addText(const TextDescription& d, const QString& value, RichParameterList& list) {
    if (d.files.isEmpty())
        add<RichString>(d, list, value);
    else
        add<RichFileToSave>(d, list, value, d.files);
}

QString readText(const TextDescription& d, const QString& fallback, const RichParameterList& list) {
    if (!list.hasParameter(d.name)) return fallback;
    const Value& value = list.getParameterByName(d.name).value();
    if (!value.isString()) refuseValue("not a text", d.label, "one");
    return value.getString();
}

QColor readColor(const QString& name, const QColor& fallback, const RichParameterList& list) {
    if (!list.hasParameter(name)) return fallback;
    const Value& value = list.getParameterByName(name).value();
    return value.isColor() ? value.getColor() : fallback;
}

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

void refuseValue(const QString& value, const QString& label, const QString& allowed) {
    laplacian_lines::refuse_value(QString("\"%1\"").arg(label).toStdString(), value.toStdString(),
                                  allowed.toStdString());
}

}  // namespace meshlab_host
