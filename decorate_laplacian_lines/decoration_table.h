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

/// The decoration's own, or one of the core's line style.
using ParameterRow = std::variant<DecorationRow, StyleRow, ColorRow>;

struct ParameterGroup {
    const char* heading;  ///< null: none
    std::vector<ParameterRow> rows;
};

/// What everybody uses first.
const std::vector<ParameterGroup>& decorationTable();

/// Of former versions, a constant now.
struct GoneParameter {
    QString key, label;
    QString usual;    ///< its default, which MeshLab keeps of those that were never set
    QString value;    ///< what it always is
    QString instead;  ///< what to do, a sentence
};
std::vector<GoneParameter> goneParameters();

/// A parameter that stands for others, which only count if it leaves them alone.
struct Override {
    const char* key;
    const char* label;
    const char* value;     ///< of a choice, that leaves the others alone
    const char* sentence;  ///< why the others are off
};

/// What may override the parameter with this key: the drawing style or the choice of lines; null if
/// nothing does.
const Override* overrideOf(const std::string& key);

bool isOverridden(const std::string& key, const DecorationParameters& chosen);
