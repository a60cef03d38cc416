// SPDX-License-Identifier: GPL-3.0-or-later
#include "decoration_settings.h"

#include <functional>
#include <vector>

#include "decoration_table.h"
#include "laplacian_lines/error.h"
#include "meshlab_host/parameter_text.h"

namespace {

/// Any row of the tables, as far as its text goes.
struct TextRow {
    QString key;
    QString label;
    QString allowed;
    std::function<QString(const QString&)> value;  ///< as the dialog has it; throws
};

template <class Options>
TextRow textRow(const laplacian_lines::OptionDescription<Options>& row) {
    const meshlab_host::ParameterDescription description = meshlab_host::describe(row, "");
    return {row.key, row.label, meshlab_host::allowedValues(description),
            [description](const QString& text) {
                return meshlab_host::textOf(meshlab_host::valueIn(text, description), description);
            }};
}

TextRow textRow(const ColorRow& row) {
    const QString label = row.label, allowed = "a color, such as #202020 or gray";
    return {row.key, label, allowed, [label, allowed](const QString& text) {
                const QColor color(text);
                if (!color.isValid()) meshlab_host::refuseValue(text, label, allowed);
                return color.name();
            }};
}

std::vector<TextRow> textRows() {
    std::vector<TextRow> rows;
    for (const ParameterGroup& group : decorationTable())
        for (const ParameterRow& row : group.rows)
            std::visit([&](const auto& r) { rows.push_back(textRow(r)); }, row);
    return rows;
}

[[noreturn]] void refuse(const QString& sentence) {
    QStringList lines = {sentence + " A setting is NAME=VALUE, of these:"};
    for (const TextRow& row : textRows())
        lines << QString("  %1 (%2): %3").arg(row.label, row.key, row.allowed);
    throw laplacian_lines::Error(laplacian_lines::ErrorCode::InvalidOption,
                                 lines.join('\n').toStdString());
}

}  // namespace

DecorationSetting readDecorationSetting(const QString& text) {
    if (!text.contains('=')) refuse(QString("\"%1\" has no value.").arg(text));
    const QString name = text.section('=', 0, 0).trimmed();
    for (const TextRow& row : textRows())
        if (name.compare(row.label, Qt::CaseInsensitive) == 0 ||
            name.compare(row.key, Qt::CaseInsensitive) == 0)
            return {row.key, row.label, row.value(text.section('=', 1).trimmed())};
    refuse(QString("The decoration has no parameter \"%1\".").arg(name));
}
