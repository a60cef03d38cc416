// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_values.h"

#include "decoration_table.h"
#include "laplacian_lines/option_table.h"

namespace driver {

using laplacian_lines::OptionDescription;
using laplacian_lines::OptionKind;

namespace {

/// A field of a dialog and what a user may type into it.
struct Setting {
    QString label;
    OptionKind kind;
    double minimum, maximum, usual;
};

template <class Options>
Setting settingOf(const OptionDescription<Options>& row) {
    return {row.label, row.kind, row.minimum, row.maximum, row.get(Options())};
}

QString write(const Setting& setting, double value) {
    QString text = QString::number(value, 'g', 6);
    if (setting.kind == OptionKind::Boolean) text = value > 0 ? "on" : "off";
    QString label = setting.label;
    if (setting.kind == OptionKind::Length) label += " (abs and %)";
    return label + " = " + text;
}

bool isFreelyTyped(const Setting& setting) {
    return setting.kind == OptionKind::Real || setting.kind == OptionKind::Integer;
}

double wholeIf(const Setting& setting, double value) {
    return setting.kind == OptionKind::Real ? value : double(int(value));
}

QString randomly(Dice& dice, const Setting& setting) {
    if (setting.kind == OptionKind::Length)
        return setting.label + " (abs and %) = " + QString::number(dice.between(0, 12)) + '%';
    if (!isFreelyTyped(setting)) return write(setting, dice.below(1 + int(setting.maximum)));
    switch (dice.below(16)) {
        case 0:
            return write(setting, setting.minimum);
        case 1:
            return write(setting, setting.maximum);
        case 2:
            return write(setting, setting.minimum - 1);  // too small
        case 3:
            return write(setting, setting.maximum * 2 + 1);  // too large
        case 4:
            return setting.kind == OptionKind::Real ? setting.label + " = nan"
                                                    : write(setting, setting.usual);
        case 5:
        case 6:
        case 7:
            return write(setting, wholeIf(setting, dice.between(setting.minimum, setting.maximum)));
        default:  // of the usual size
            return write(setting, wholeIf(setting, setting.usual * dice.between(0, 2.5)));
    }
}

std::vector<Setting> decorationSettings() {
    std::vector<Setting> settings;
    for (const ParameterGroup& group : decorationTable())
        for (const ParameterRow& row : group.rows) {
            if (const auto* own = std::get_if<DecorationRow>(&row))
                settings.push_back(settingOf(*own));
            if (const auto* of_style = std::get_if<StyleRow>(&row))
                settings.push_back(settingOf(*of_style));
        }
    return settings;
}

/// One to four of them.
QStringList some(Dice& dice, const std::vector<Setting>& settings) {
    QStringList result;
    for (int i = 1 + dice.below(4); i > 0; --i)
        result << randomly(dice, dice.from(settings));
    return result;
}

QString randomPlace(Dice& dice, double size) {
    if (dice.oneIn(8)) return "0 0 0";
    QStringList numbers;
    for (int axis = 0; axis < 3; ++axis)
        numbers << QString::number(dice.between(-size, size));
    return numbers.join(' ');
}

}  // namespace

DecorationSetting randomDecorationSetting(Dice& dice) {
    const Setting setting = dice.from(decorationSettings());
    return {randomly(dice, setting), write(setting, setting.usual)};
}

QStringList randomComputeSettings(Dice& dice) {
    std::vector<Setting> settings;
    for (const auto& row : laplacian_lines::precompute_option_table())
        settings.push_back(settingOf(row));
    return some(dice, settings);
}

QStringList randomPolylineSettings(Dice& dice) {
    std::vector<Setting> settings;
    for (const auto& row : laplacian_lines::line_style_table())
        if (!row.for_experts) settings.push_back(settingOf(row));
    QStringList result = some(dice, settings);
    if (dice.oneIn(2)) {
        result << QString("View = %1").arg(dice.below(9));
        result << "Viewpoint = " + randomPlace(dice, 5);
        result << "View Direction = " + randomPlace(dice, 1);
        result << QString("Settings = %1").arg(dice.below(2));
        result << (dice.oneIn(2) ? "Visible Lines Only = on" : "Visible Lines Only = off");
    }
    return result;
}

}  // namespace driver
