// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of options against their tables, and what a refusal says.
#include "laplacian_lines/option_table.h"

#include <cmath>
#include <sstream>

#include "laplacian_lines/error.h"

namespace laplacian_lines {
namespace {

std::string in_words(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

template <class Options>
void check_ranges(const std::vector<OptionRow<Options>>& table, const Options& options) {
    for (const auto& option : table) {
        const double value = option.get(options);
        if (!(value >= option.minimum && value <= option.maximum))
            refuse_value(option, in_words(value));
    }
}

}  // namespace

std::string allowed_values(const OptionDescription& option) {
    switch (option.kind) {
        case OptionKind::Boolean:
            return "on or off";
        case OptionKind::Choice: {
            std::string items;
            for (std::size_t i = 0; i < option.choices.size(); ++i)
                items += (i > 0 ? ", " : "") + std::to_string(i) + " (" + option.choices[i] + ")";
            return "one of " + items;
        }
        case OptionKind::Color:
            return "a color, such as #202020 or gray";
        case OptionKind::Text:
        case OptionKind::File:
            return "a text";
        case OptionKind::Position:
            return "three finite numbers";
        case OptionKind::Direction:
            return "three finite numbers, not all 0";
        case OptionKind::Real:
        case OptionKind::Length:
            break;
    }
    if (option.maximum == kUnlimited) return "at least " + in_words(option.minimum) + " and finite";
    return "between " + in_words(option.minimum) + " and " + in_words(option.maximum);
}

void refuse_value(const std::string& what, const std::string& value, const std::string& allowed) {
    refuse(what + " is " + value + ". It has to be " + allowed + ".");
}

void refuse_value(const OptionDescription& option, const std::string& value,
                  const std::string& remark) {
    refuse_value('"' + std::string(option.label) + '"', value, allowed_values(option) + remark);
}

void validate(const PrecomputeOptions& options) {
    check_ranges(precompute_option_table(), options);
    if (!(options.drawn_kernel_size >= 0 && std::isfinite(options.drawn_kernel_size)))
        refuse_value("drawn_kernel_size", in_words(options.drawn_kernel_size), "finite and >= 0");
    if (!(options.least_drawn_edges > 0 && std::isfinite(options.least_drawn_edges)))
        refuse_value("least_drawn_edges", in_words(options.least_drawn_edges), "finite and > 0");
}

void validate(const LineStyle& style) {
    check_ranges(line_style_table(), style);
}

}  // namespace laplacian_lines
