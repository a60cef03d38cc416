// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "decoration_parameters.h"
#include "laplacian_lines/option_table.h"

using DecorationRow = laplacian_lines::OptionDescription<DecorationParameters>;

struct ColorRow {
    const char* key;
    const char* label;
    const char* help;
    QColor& (*color)(DecorationParameters&);
};

/// Which rows of the core's line style stand in a group.
enum class StyleRows { None, Everyday, ForExperts };

/// Parameters that stand together in the layer dialog: rows, those of the line style, colors.
struct ParameterGroup {
    const char* heading;  ///< null: none
    std::vector<DecorationRow> rows;
    StyleRows style_rows = StyleRows::None;
    std::vector<ColorRow> colors = {};
};

/// All parameters of the decoration, what everybody uses first.
const std::vector<ParameterGroup>& decorationTable();
