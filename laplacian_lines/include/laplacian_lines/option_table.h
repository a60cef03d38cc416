// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "laplacian_lines/line_style.h"
#include "laplacian_lines/precompute_options.h"

namespace laplacian_lines {

enum class OptionKind {
    Real,       ///< a dimensionless number, or in the unit that its help names
    Length,     ///< a length in mesh units; user interfaces may offer percent of the diagonal
    Boolean,    ///< 0 or 1
    Choice,     ///< index into `choices`
    Color,      ///< 0xRRGGBB
    Text,       ///< any
    File,       ///< name of a file to write; `choices` are its possible endings
    Position,   ///< in world coordinates
    Direction,  ///< in world coordinates, of any length but 0
};

constexpr double kUnlimited = std::numeric_limits<double>::max();

/// The texts and limits of an option.
struct OptionDescription {
    const char* key;    ///< identifier in scripts, stable between versions
    const char* label;  ///< short name in dialogs
    const char* help;   ///< what it does, with its unit
    OptionKind kind;
    double minimum;  ///< of numbers; texts and vectors have no limits
    double maximum;  ///< kUnlimited if there is none
    std::vector<const char*> choices;
};

using OptionValue = std::variant<double, std::string, Eigen::Vector3d>;

/// A member of an options struct. Parameters of dialogs and scripts, and checks of their ranges,
/// are made from these rows; defaults are those of a default-constructed struct.
template <class Options>
struct OptionRow : OptionDescription {
    double (*get)(const Options&);  ///< null for texts and vectors, as set
    void (*set)(Options&, double);
    std::string Options::*text = nullptr;        ///< of Text and File
    Eigen::Vector3d Options::*vector = nullptr;  ///< of Position and Direction

    OptionValue value(const Options& options) const {
        if (text) return options.*text;
        if (vector) return options.*vector;
        return get(options);
    }
    /// @throws std::bad_variant_access for a value of another kind
    void set_value(Options& options, const OptionValue& value) const {
        if (text)
            options.*text = std::get<std::string>(value);
        else if (vector)
            options.*vector = std::get<Eigen::Vector3d>(value);
        else
            set(options, std::get<double>(value));
    }
};

/// What is allowed, after "It has to be": "between 0 and 100", "one of 0 (None), 1 (Gaussian)".
std::string allowed_values(const OptionDescription& option);

/// "WHAT is VALUE. It has to be ALLOWED." @throws Error(InvalidOption), always
[[noreturn]] void refuse_value(const std::string& what, const std::string& value,
                               const std::string& allowed);
/// Of an option, by its label; `remark` follows what is allowed.
[[noreturn]] void refuse_value(const OptionDescription& option, const std::string& value,
                               const std::string& remark = {});

const std::vector<OptionRow<PrecomputeOptions>>& precompute_option_table();
const std::vector<OptionRow<LineStyle>>& line_style_table();

}  // namespace laplacian_lines
