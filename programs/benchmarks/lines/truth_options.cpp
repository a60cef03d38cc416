// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_options.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace benchmarks {

using namespace laplacian_lines;

namespace {

LineKindSet kinds_named(const std::string& text) {
    LineKindSet kinds;
    for (const std::string& key : split(text, ',')) {
        bool found = false;
        for (const LineKindDescription& row : line_kinds)
            if (key == row.key) kinds[row.kind] = found = true;
        if (!found) throw std::invalid_argument("there is no kind '" + key + "'");
    }
    return kinds;
}

template <class Options>
const OptionDescription<Options>* row_of(const std::vector<OptionDescription<Options>>& table,
                                         const std::string& key) {
    for (const auto& row : table)
        if (key == row.key) return &row;
    return nullptr;
}

/// @throws std::invalid_argument with `what` unless all are
template <class Test>
void demand(const std::vector<double>& values, const char* what, Test is_right) {
    if (!std::all_of(values.begin(), values.end(), is_right)) throw std::invalid_argument(what);
}

}  // namespace

TruthOptions::TruthOptions() {
    for (const LineKind kind : {LineKind::Laplacian, LineKind::Ridge, LineKind::Crease})
        kinds[kind] = true;
}

PrecomputeOptions TruthOptions::field_options(double diagonal) const {
    PrecomputeOptions options = field_;
    for (const auto& [row, percent] : field_percents_)
        row->set(options, percent / 100 * diagonal);
    return options;
}

void TruthOptions::set(const std::string& key_and_value) {
    const std::size_t equals = key_and_value.find('=');
    if (equals == std::string::npos) throw std::invalid_argument("--set wants KEY=VALUE");
    const std::string key = key_and_value.substr(0, equals);
    std::string value = key_and_value.substr(equals + 1);
    const auto* of_style = row_of(line_style_table(), key);
    const auto* of_field = row_of(precompute_option_table(), key);
    if (of_style) {
        of_style->set(style, parse_number(value));
    } else if (!of_field) {
        throw std::invalid_argument("there is no option '" + key + "'");
    } else if (of_field->kind == OptionKind::Length && !value.empty() && value.back() == '%') {
        value.pop_back();
        field_percents_.emplace_back(of_field, parse_number(value));
    } else {
        of_field->set(field_, parse_number(value));
    }
}

std::vector<Option> TruthOptions::words() {
    std::string tables;
    for (const TruthTable& table : truth_tables())
        tables += (tables.empty() ? "" : "|") + std::string(table.name);
    return {
        text("--only " + tables, "one of the tables", only),
        numbers("--seeds 1,2,3", "of stones", seeds),
        number("--ripples 5", "of stones: how far they turn the surface, degrees", ripple_angle),
        numbers("--radii 0.5,1,2", "of edges, % of D", radii),
        numbers("--resolutions 1,4,16", "times 20,480 triangles (stones) or about 33,000 (parts)",
                resolutions),
        numbers("--noise 0,10,20", "of stones and parts, % of the mean edge", noise),
        numbers("--drawing-noise 20,40", "of drawings", drawing_noise),
        numbers("--drawing-seeds 1", "of this noise, whose scores are of all together",
                drawing_seeds),
        numbers("--voxels 80,160", "along each axis, of terraces", voxels),
        number("--reach 1", "between an arris and its line, % of D; also of terraces", reach, 1e-9),
        number("--drawing-reach 0.5", "between lines of two drawings", drawing_reach, 1e-9),
        number("--sharp 15", "degrees: sharper arrises have to be drawn", sharp_angle),
        number("--blunt 8", "degrees: sharper arrises may be drawn", blunt_angle),
        number("--opacity 0.1", "the least that counts as drawn", least_opacity),
        {"--kinds laplacian_lines,ridges,creases", "by which arrises may be drawn",
         [this](const std::string& text) { kinds = kinds_named(text); }},
        {"--set KEY=VALUE", "of the field or the style; lengths also as VALUE%, of D",
         [this](const std::string& text) { set(text); }}};
}

void TruthOptions::check() const {
    const auto& tables = truth_tables();
    if (!only.empty() && std::none_of(tables.begin(), tables.end(),
                                      [&](const TruthTable& t) { return only == t.name; }))
        throw std::invalid_argument("there is no table '" + only + "'");
    demand(voxels, "voxels are whole numbers from 10 to 1000",
           [](double v) { return v >= 10 && v <= 1000 && v == std::floor(v); });
    demand(resolutions, "resolutions are powers of 4, from 1/64 to 256",
           [](double v) { return v >= 1 / 64. && v <= 256 && std::fmod(std::log2(v), 2) == 0; });
    validate(style);
    validate(field_options(1));
}

}  // namespace benchmarks
