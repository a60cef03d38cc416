// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>
#include <utility>
#include <vector>

#include "laplacian_lines/option_table.h"

/// Makes the rows of an option table. A row's member is a path of member pointers from the options
/// struct to a number, a switch or an enumeration. Public, for programs with options of their own.
namespace laplacian_lines::option_rows {

template <class Owner, class Value, class... Rest>
Owner owner_of(Value Owner::*, Rest...);
template <auto... Path>
using OptionsOf = decltype(owner_of(Path...));

template <auto... Path>
OptionRow<OptionsOf<Path...>> row(const char* key, const char* label, OptionKind kind,
                                  double minimum, double maximum, const char* help,
                                  std::vector<const char*> choices = {}) {
    using Options = OptionsOf<Path...>;
    return {{key, label, help, kind, minimum, maximum, std::move(choices)},
            [](const Options& options) { return static_cast<double>((options.*....*Path)); },
            [](Options& options, double value) {
                auto& member = (options.*....*Path);
                using Type = std::decay_t<decltype(member)>;
                if constexpr (std::is_floating_point_v<Type>)
                    member = static_cast<Type>(value);
                else
                    member = static_cast<Type>(static_cast<int>(value));
            }};
}

template <auto... Path>
auto real(const char* key, const char* label, double minimum, double maximum, const char* help) {
    return row<Path...>(key, label, OptionKind::Real, minimum, maximum, help);
}

template <auto... Path>
auto boolean(const char* key, const char* label, const char* help) {
    return row<Path...>(key, label, OptionKind::Boolean, 0, 1, help);
}

template <auto... Path>
auto choice(const char* key, const char* label, std::vector<const char*> choices,
            const char* help) {
    const double last = double(choices.size()) - 1;
    return row<Path...>(key, label, OptionKind::Choice, 0, last, help, std::move(choices));
}

template <class Options>
OptionRow<Options> text(std::string Options::*member, const char* key, const char* label,
                        const char* help) {
    return {{key, label, help, OptionKind::Text, 0, 0, {}}, nullptr, nullptr, member};
}

/// `endings`: "svg" and so on.
template <class Options>
OptionRow<Options> file(std::string Options::*member, const char* key, const char* label,
                        const char* help, std::vector<const char*> endings) {
    return {
        {key, label, help, OptionKind::File, 0, 0, std::move(endings)}, nullptr, nullptr, member};
}

/// Position or Direction.
template <class Options>
OptionRow<Options> vector(Eigen::Vector3d Options::*member, const char* key, const char* label,
                          OptionKind kind, const char* help) {
    return {{key, label, help, kind, 0, 0, {}}, nullptr, nullptr, nullptr, member};
}

/// Whether a kind of lines is in the LineKindSet at the end of the path.
template <LineKind Kind, auto... Path>
OptionRow<OptionsOf<Path...>> kind_switch() {
    using Options = OptionsOf<Path...>;
    constexpr const LineKindDescription& kind = describe(Kind);
    return {{kind.key, kind.label, kind.help, OptionKind::Boolean, 0, 1, {}},
            [](const Options& options) { return (options.*....*Path)[Kind] ? 1. : 0.; },
            [](Options& options, double value) { (options.*....*Path)[Kind] = value != 0; }};
}

}  // namespace laplacian_lines::option_rows
