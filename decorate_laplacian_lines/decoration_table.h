// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "decoration_parameters.h"
#include "laplacian_lines/option_table.h"

using DecorationRow = laplacian_lines::OptionDescription<DecorationParameters>;
using StyleRow = laplacian_lines::OptionDescription<laplacian_lines::LineStyle>;

struct ColorRow {
    const char* key;
    const char* label;
    const char* help;
    QColor& (*color)(DecorationParameters&);
    bool for_experts = false;
    std::optional<laplacian_lines::LineKind> kind = {};  ///< whose own color it is
};

/// A parameter: one of the decoration's own or of the core's line style.
using ParameterRow = std::variant<DecorationRow, StyleRow, ColorRow>;

/// Parameters that stand together in the layer dialog.
struct ParameterGroup {
    const char* heading;  ///< null: none
    std::vector<ParameterRow> rows;
};

/// All parameters of the decoration, what everybody uses first.
const std::vector<ParameterGroup>& decorationTable();

/// One that former versions had and that is a constant now.
struct GoneParameter {
    QString key, label;
    QString usual;    ///< its default, which MeshLab keeps of those that were never set
    QString value;    ///< what it always is
    QString instead;  ///< what to do, a sentence
};
std::vector<GoneParameter> goneParameters();

/// A parameter that stands for others, which have no effect unless it leaves them alone.
struct Override {
    const char* key;
    const char* label;
    const char* value;     ///< of a choice, that leaves the others alone
    const char* sentence;  ///< why the others are off
};

/// What may override the parameter with this key: the drawing style or the choice of lines; null
/// for those that always count.
const Override* overrideOf(const std::string& key);

/// Whether it does, with what is chosen.
bool isOverridden(const std::string& key, const DecorationParameters& chosen);
