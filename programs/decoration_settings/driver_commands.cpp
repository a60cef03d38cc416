// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver_commands.h"

#include "decoration_parameters.h"
#include "laplacian_lines/error.h"
#include "meshlab_host/parameters.h"

using laplacian_lines::LineKindDescription;
using laplacian_lines::LineKindSet;

namespace {

[[noreturn]] void refuse(const QString& sentence) {
    QStringList lines = {sentence + " A setting is NAME=VALUE, of these:"};
    for (const auto& row : decoration_table())
        lines << QString("  %1 (%2): %3")
                     .arg(row.label, row.key,
                          QString::fromStdString(laplacian_lines::allowed_values(row)));
    laplacian_lines::refuse(lines.join('\n').toStdString());
}

QString command(const QString& label, const QString& value) {
    return QString("setdeco %1 = %2").arg(label, value);
}

QString setting_command(const QString& text) {
    if (!text.contains('=')) refuse(QString("\"%1\" has no value.").arg(text));
    const QString name = text.section('=', 0, 0).trimmed();
    const QString value = text.section('=', 1).trimmed();
    for (const auto& row : decoration_table())
        if (!name.compare(row.label, Qt::CaseInsensitive) ||
            !name.compare(row.key, Qt::CaseInsensitive))
            return command(row.label,
                           meshlab_host::text_of(meshlab_host::number_in(value, row), row));
    refuse(QString("The decoration has no parameter \"%1\".").arg(name));
}

QStringList tick(const LineKindSet& kinds) {
    QStringList commands = {command("Lines", "As Ticked Below")};
    for (const LineKindDescription& kind : laplacian_lines::kLineKinds)
        if (kind.shown) commands << command(kind.label, kinds[kind.kind] ? "on" : "off");
    return commands;
}

/// Of a kind, by its key; of others as given.
QString label_of(const QString& name, const QString& other) {
    for (const LineKindDescription& kind : laplacian_lines::kLineKinds)
        if (name == kind.key) return kind.label;
    return other;
}

QStringList mixture_keys() {
    QStringList keys;
    for (const laplacian_lines::LineMixture& mixture : laplacian_lines::kLineMixtures)
        keys << mixture.key;
    return keys;
}

bool can_be_ticked(const LineKindSet& kinds) {
    return (kinds | LineKindSet::defaults()) == LineKindSet::defaults();
}

ComparedPicture picture_of(const QString& name) {
    if (const auto* mixture = laplacian_lines::mixture_named(name.toStdString()))
        return {label_of(name, mixture->label), {command("Lines", mixture->label)}};
    const auto kinds = laplacian_lines::kinds_named(name.toStdString());
    if (kinds && can_be_ticked(*kinds)) return {label_of(name, name), tick(*kinds)};
    laplacian_lines::refuse(
        QString("there is no picture of lines \"%1\". Name some of usual, %2, or all; or ridges, "
                "creases, borders, laplacian_lines, with + between what is to be in one.")
            .arg(name, mixture_keys().join(", "))
            .toStdString());
}

}  // namespace

QStringList setting_commands(const QStringList& settings) {
    QStringList commands;
    for (const QString& setting : settings)
        commands << setting_command(setting);
    return commands;
}

std::vector<ComparedPicture> compared_pictures(const QString& names) {
    QStringList wanted;
    for (const QString& name : names.split(','))
        if (name.trimmed() == "all") {
            wanted << mixture_keys();
            wanted.removeOne("all_kinds");
        } else {
            wanted << name.trimmed();
        }
    std::vector<ComparedPicture> pictures;
    for (const QString& name : wanted)
        pictures.push_back(picture_of(name));
    return pictures;
}
