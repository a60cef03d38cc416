// SPDX-License-Identifier: GPL-3.0-or-later
#include "decoration_settings.h"

#include <QRegularExpression>
#include <QSettings>
#include <algorithm>
#include <functional>
#include <utility>

#include "decoration_table.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/line_mixture.h"
#include "meshlab_host/parameters.h"

namespace {

/// The text of any row of the tables.
struct TextRow {
    QString key;
    QString label;
    QString allowed;
    std::function<QString(const QString&)> value;  ///< as the dialog has it; throws
};

template <class Options>
TextRow textRow(const laplacian_lines::OptionDescription<Options>& row) {
    const meshlab_host::ParameterDescription description = meshlab_host::describe(row, "");
    return {row.key, row.label, description.allowed, [description](const QString& text) {
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

bool isNamed(const QString& name, const QString& label, const QString& key) {
    return name.compare(label, Qt::CaseInsensitive) == 0 ||
           name.compare(key, Qt::CaseInsensitive) == 0;
}

QString sentenceOf(const GoneParameter& gone) {
    return QString("\"%1\" can no longer be set, it is always %2. %3")
        .arg(gone.label, gone.value, gone.instead);
}

/// From what MeshLab keeps, <Param value="..."/>, to the dialog's words.
QString valueIn(const QString& kept) {
    const auto attribute = [&](const char* name) {
        return QRegularExpression(QString("\\b%1=\"([^\"]*)\"").arg(name)).match(kept).captured(1);
    };
    const QString value = attribute("value");
    if (value.isEmpty())
        return QColor(attribute("r").toInt(), attribute("g").toInt(), attribute("b").toInt())
            .name();
    if (value == "true" || value == "false") return value == "true" ? "on" : "off";
    return QString::number(value.toDouble());
}

[[noreturn]] void refuse(const QString& sentence) {
    QStringList lines = {sentence + " A setting is NAME=VALUE, of these:"};
    for (const TextRow& row : textRows())
        lines << QString("  %1 (%2): %3").arg(row.label, row.key, row.allowed);
    laplacian_lines::refuse(lines.join('\n').toStdString());
}

}  // namespace

DecorationSetting readDecorationSetting(const QString& text) {
    if (!text.contains('=')) refuse(QString("\"%1\" has no value.").arg(text));
    const QString name = text.section('=', 0, 0).trimmed();
    for (const TextRow& row : textRows())
        if (isNamed(name, row.label, row.key))
            return {row.key, row.label, row.value(text.section('=', 1).trimmed())};
    for (const GoneParameter& gone : goneParameters())
        if (isNamed(name, gone.label, gone.key))
            laplacian_lines::refuse(sentenceOf(gone).toStdString());
    refuse(QString("The decoration has no parameter \"%1\".").arg(name));
}

QStringList ignoredSettings() {
    const QSettings settings;
    QStringList lines;
    for (const GoneParameter& gone : goneParameters()) {
        const QVariant kept = settings.value(decoration_prefix + gone.key);
        if (kept.isValid() && valueIn(kept.toString()) != gone.usual)
            lines << "A setting of a former version is ignored: " + sentenceOf(gone);
    }
    return lines;
}

namespace {

using laplacian_lines::LineKind;
using laplacian_lines::LineKindSet;

const char* const compared = "all";

QString command(const QString& label, const QString& value) {
    return QString("setdeco %1 = %2").arg(label, value);
}

QString command(const DecorationSetting& setting) {
    return command(setting.label, setting.value);
}

bool isAmong(const QString& label, const std::vector<DecorationSetting>& settings) {
    return std::any_of(settings.begin(), settings.end(),
                       [&](const DecorationSetting& s) { return s.label == label; });
}

std::vector<DecorationSetting> readAll(const QStringList& texts) {
    std::vector<DecorationSetting> settings;
    for (const QString& text : texts)
        settings.push_back(readDecorationSetting(text));
    return settings;
}

QStringList switches(const LineKindSet& kinds) {
    QStringList settings;
    for (const auto& kind : laplacian_lines::line_kinds)
        settings << QString("%1=%2").arg(kind.key, kinds[kind.kind] ? "on" : "off");
    return settings;
}

QString labelOf(const QString& name) {
    for (const auto& kind : laplacian_lines::line_kinds)
        if (name == kind.key) return kind.label;
    const auto* mixture = laplacian_lines::mixture_named(name.toStdString());
    return mixture ? QString(mixture->label) : name;
}

/// White lights and dark contours, as in the paper that has them, need a darker paper.
void showHighlights(ComparedPicture& picture, const std::vector<DecorationSetting>& settings) {
    const QString paper = "Paper Color", lights = "Highlight Color";
    if (isAmong(paper, settings) || isAmong(lights, settings)) return;
    picture.before << command(paper, "#a8a8a8") << command(lights, "#ffffff");
    picture.after << command(paper, "#ffffff")
                  << command(lights,
                             QColor(describe(LineKind::SuggestiveHighlight).key_color).name());
}

ComparedPicture pictureOfKinds(const QString& name,
                               const std::vector<DecorationSetting>& settings) {
    const auto kinds = laplacian_lines::kinds_named(name.toStdString());
    if (!kinds)
        laplacian_lines::refuse(
            QString("there are no lines \"%1\". Name some of %2, or all; one picture each, with + "
                    "between what is to be in one.")
                .arg(name, QString::fromStdString(laplacian_lines::names_of_kinds()))
                .toStdString());
    ComparedPicture picture{labelOf(name), {}, {}};
    if (const auto* mixture = laplacian_lines::mixture_named(name.toStdString()))
        picture.before << command("Lines", mixture->label);
    else
        picture.before << settingCommands(switches(*kinds));
    if ((*kinds)[LineKind::SuggestiveHighlight] && !(*kinds)[LineKind::Laplacian])
        showHighlights(picture, settings);
    return picture;
}

/// Each mixture but that of all kinds.
QStringList allCompared() {
    QStringList names;
    for (const auto& mixture : laplacian_lines::line_mixtures)
        if (!(mixture.kinds == laplacian_lines::all_kinds())) names << mixture.key;
    return names;
}

}  // namespace

QStringList settingCommands(const QStringList& texts) {
    const std::vector<DecorationSetting> settings = readAll(texts);
    QStringList commands;
    for (const DecorationSetting& setting : settings) {
        const Override* overriding = overrideOf(setting.key.toStdString());
        if (!overriding || isAmong(overriding->label, settings)) continue;
        const QString release = command(overriding->label, overriding->value);
        if (!commands.contains(release)) commands << release;
    }
    for (const DecorationSetting& setting : settings)
        commands << command(setting);
    return commands;
}

std::vector<ComparedPicture> comparedPictures(const QString& names, const QStringList& texts) {
    const std::vector<DecorationSetting> settings = readAll(texts);
    QStringList all;
    for (const QString& name : names.split(','))
        if (name.trimmed() == compared)
            all << allCompared();
        else
            all << name.trimmed();
    std::vector<ComparedPicture> pictures;
    for (const QString& name : all)
        pictures.push_back(pictureOfKinds(name, settings));
    return pictures;
}
