// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
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
