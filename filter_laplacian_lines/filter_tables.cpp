// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "filter_laplacian_lines.h"
#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/line_kind.h"
#include "meshlab_host/parameters.h"
#include "polyline_parameters.h"

using laplacian_lines::OptionKind;
using meshlab_host::ParameterDescription;

namespace {

const char* nameOf(OptionKind kind) {
    switch (kind) {
        case OptionKind::Real:
            return "real";
        case OptionKind::Integer:
            return "integer";
        case OptionKind::Length:
            return "length";
        case OptionKind::Boolean:
            return "boolean";
        case OptionKind::Choice:
            break;
    }
    return "choice";
}

QJsonObject describe(const ParameterDescription& d, double value) {
    QJsonObject object{{"kind", nameOf(d.kind)}};
    object["default"] = d.kind == OptionKind::Boolean ? QJsonValue(value != 0) : QJsonValue(value);
    if (d.kind == OptionKind::Choice) {
        object["choices"] = QJsonArray::fromStringList(d.choices);
    } else if (d.kind != OptionKind::Boolean) {
        object["minimum"] = d.minimum;
        if (d.hasMaximum()) object["maximum"] = d.maximum;
    }
    return object;
}

QJsonObject describePlace(const QString& key) {
    QJsonObject object{{"kind", "place"}};
    for (const PlaceUse& use : polylinePlaces())
        if (use.place == key) {
            object["counts_by"] = use.parameter;
            object["counts_at"] = use.choice;
        }
    return object;
}

QJsonObject describeOther(const RichParameter& parameter) {
    const std::optional<QString> text = meshlab_host::defaultText(parameter);
    if (text) return {{"kind", "text"}, {"default", *text}};
    return describePlace(parameter.name());
}

QJsonObject describe(const RichParameter& parameter,
                     const std::vector<ParameterDescription>& descriptions) {
    QJsonObject object = describeOther(parameter);
    for (const ParameterDescription& description : descriptions)
        if (description.name == parameter.name())
            object = describe(description, meshlab_host::defaultOf(parameter).value_or(0));
    object["key"] = parameter.name();
    object["label"] = parameter.fieldDescription();
    object["help"] = parameter.toolTip();
    return object;
}

QJsonArray filters() {
    QJsonArray result;
    for (const auto& filter : makeFilters()) {
        RichParameterList list;
        filter->listParameters(nullptr, list);
        const std::vector<ParameterDescription> descriptions = filter->describeParameters();
        QJsonArray parameters;
        for (const RichParameter& parameter : list)
            parameters.append(describe(parameter, descriptions));
        const meshlab_host::FilterDescription about = filter->description();
        result.append(QJsonObject{{"name", about.name},
                                  {"python_name", about.python_name},
                                  {"help", about.help},
                                  {"parameters", parameters}});
    }
    return result;
}

QJsonArray columns() {
    QJsonArray result;
    for (const laplacian_lines::FieldColumn& column : laplacian_lines::field_columns)
        for (const laplacian_lines::FieldAttribute& attribute : column.attributes)
            if (attribute.floats > 0)
                result.append(QJsonObject{{"name", attribute.name},
                                          {"numbers", int(attribute.floats)},
                                          {"help", QString::fromUtf8(column.help)},
                                          {"unit", QString::fromUtf8(column.unit)},
                                          {"optional", bool(column.optional)}});
    return result;
}

QJsonArray kinds() {
    QJsonArray result;
    for (const laplacian_lines::LineKindDescription& kind : laplacian_lines::line_kinds)
        result.append(QJsonObject{{"key", kind.key},
                                  {"one", kind.one},
                                  {"many", kind.many},
                                  {"outline", kind.is_outline},
                                  {"color", int(kind.color)},
                                  {"width", kind.width}});
    return result;
}

}  // namespace

/// The tables behind the dialogs, for programs without dialogs: a JSON object, UTF-8, that lives as
/// long as the plugin:
///     filters   name, python_name, help and parameters of each: key, label, help, default, kind
///               ("real", "integer", "length", "boolean", "choice", "text", "place"), minimum and
///               maximum (absent if there is no limit), choices; of places, by which choice of
///               which parameter they count
///     columns   the attributes of fields: name, numbers a vertex, help, unit, optional
///     kinds     the kinds of lines in the order of their numbers: key, one, many, outline, color
///               (0xRRGGBB), width
extern "C" Q_DECL_EXPORT const char* laplacian_lines_tables() {
    static const QByteArray json =
        QJsonDocument(
            QJsonObject{{"filters", filters()}, {"columns", columns()}, {"kinds", kinds()}})
            .toJson(QJsonDocument::Compact);
    return json.constData();
}
