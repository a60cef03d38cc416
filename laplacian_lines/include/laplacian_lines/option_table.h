// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "laplacian_lines/line_style.h"
#include "laplacian_lines/precompute_options.h"

namespace laplacian_lines {

enum class OptionKind {
    Real,     ///< a dimensionless number, or in the unit that its help names
    Length,   ///< a length in mesh units; user interfaces may offer percent of the diagonal
    Boolean,  ///< 0 or 1
    Choice,   ///< index into `choices`
};

/// A member of an options struct. Scripts, range checks and those in dialogs are made from these
/// rows; defaults are those of a default-constructed struct.
template <class Options>
struct OptionDescription {
    const char* key;    ///< identifier in scripts, stable between versions
    const char* label;  ///< short name in dialogs
    const char* help;   ///< what it does, with its unit
    OptionKind kind;
    double minimum;
    double maximum;
    std::vector<const char*> choices;
    double (*get)(const Options&);
    void (*set)(Options&, double);
};

/// What is allowed, after "It has to be": "between 0 and 100", "one of 0 (Uniform), 1 (Adaptive)".
std::string allowed_values(OptionKind kind, double minimum, double maximum,
                           const std::vector<const char*>& choices);
template <class Options>
std::string allowed_values(const OptionDescription<Options>& row) {
    return allowed_values(row.kind, row.minimum, row.maximum, row.choices);
}

/// "WHAT is VALUE. It has to be ALLOWED." @throws Error(InvalidOption), always
[[noreturn]] void refuse_value(const std::string& what, const std::string& value,
                               const std::string& allowed);

const std::vector<OptionDescription<PrecomputeOptions>>& precompute_option_table();
const std::vector<OptionDescription<LineStyle>>& line_style_table();

}  // namespace laplacian_lines
