// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/parameters.h"

#include <cmath>

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

void addParameter(const ParameterDescription& d, double value, double diagonal,
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

double readParameter(const ParameterDescription& d, double fallback,
                     const RichParameterList& list) {
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

}  // namespace meshlab_host
