// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_options.h"

#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

namespace benchmarks {

using namespace laplacian_lines;

const char* const truth_usage =
    "line_truth [OPTION VALUE]... [MESH...]\n"
    "  --only stones|parts|drawings|kinds|crests|terraces   one of the tables\n"
    "  --seeds 1,2,3                  of stones\n"
    "  --ripples 5                    of stones: how far they turn the surface, degrees\n"
    "  --radii 0.5,1,2                of edges, % of D\n"
    "  --resolutions 1,4,16           times 20,480 triangles (stones) or about 33,000 (parts)\n"
    "  --noise 0,10,20                of stones and parts, % of the mean edge\n"
    "  --drawing-noise 20,40          of drawings\n"
    "  --drawing-seeds 1              of the noise of kinds, whose scores are of all together\n"
    "  --voxels 80,160                along each axis, of terraces\n"
    "  --crest-strengths 1,2,4        of crest lines as usually defined, their least\n"
    "  --reach 1                      between an arris and its line, % of D; also of terraces\n"
    "  --drawing-reach 0.5            between lines of two drawings\n"
    "  --sharp 15, --blunt 8          degrees: sharper arrises have to be drawn; may be drawn\n"
    "  --opacity 0.1                  the least that counts as drawn\n"
    "  --kinds laplacian_lines,ridges,creases   by which arrises may be drawn\n"
    "  --set KEY=VALUE                of the field or the style; lengths also as VALUE%, of D\n";

namespace {

std::vector<std::string> split(const std::string& text, char by) {
    std::vector<std::string> parts = {""};
    for (const char c : text)
        if (c == by)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

double number(const std::string& text) {
    std::size_t read = 0;
    double value = NAN;
    try {
        value = std::stod(text, &read);
    } catch (const std::exception&) {
    }
    if (read != text.size() || !std::isfinite(value))
        throw std::invalid_argument("'" + text + "' is no number");
    return value;
}

double not_negative(const std::string& text) {
    const double value = number(text);
    if (value < 0) throw std::invalid_argument(text + " is less than 0");
    return value;
}

std::vector<double> numbers(const std::string& text) {
    std::vector<double> values;
    for (const std::string& part : split(text, ','))
        values.push_back(not_negative(part));
    return values;
}

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

void choose_table(TruthOptions& options, const std::string& name) {
    options.stones = name == "stones";
    options.parts = name == "parts";
    options.drawings = name == "drawings";
    options.terraces = name == "terraces";
    options.kinds_alone = name == "kinds";
    options.crests = name == "crests";
    if (!options.stones && !options.parts && !options.drawings && !options.terraces &&
        !options.kinds_alone && !options.crests)
        throw std::invalid_argument("there is no table '" + name + "'");
}

std::vector<double> voxels(const std::string& text) {
    const std::vector<double> values = numbers(text);
    for (const double value : values)
        if (value < 10 || value > 1000 || value != std::floor(value))
            throw std::invalid_argument("voxels are whole numbers from 10 to 1000");
    return values;
}

std::vector<double> resolutions(const std::string& text) {
    const std::vector<double> values = numbers(text);
    for (const double value : values)
        if (value < 1 / 64. || value > 256 || std::fmod(std::log2(value), 2) != 0)
            throw std::invalid_argument("resolutions are powers of 4");
    return values;
}

using Setter = std::function<void(TruthOptions&, const std::string&)>;

const std::map<std::string, Setter>& setters() {
    using O = TruthOptions;
    const auto list = [](std::vector<double> O::*member) -> Setter {
        return [member](O& o, const std::string& text) { o.*member = numbers(text); };
    };
    const auto one = [](double O::*member) -> Setter {
        return [member](O& o, const std::string& text) { o.*member = not_negative(text); };
    };
    static const std::map<std::string, Setter> table = {
        {"--only", choose_table},
        {"--seeds", list(&O::seeds)},
        {"--ripples", one(&O::ripple_angle)},
        {"--radii", list(&O::radii)},
        {"--resolutions", [](O& o, const std::string& text) { o.resolutions = resolutions(text); }},
        {"--noise", list(&O::noise)},
        {"--drawing-noise", list(&O::drawing_noise)},
        {"--drawing-seeds", list(&O::drawing_seeds)},
        {"--voxels", [](O& o, const std::string& text) { o.voxels = voxels(text); }},
        {"--crest-strengths", list(&O::crest_strengths)},
        {"--reach", one(&O::reach)},
        {"--drawing-reach", one(&O::drawing_reach)},
        {"--sharp", one(&O::sharp_angle)},
        {"--blunt", one(&O::blunt_angle)},
        {"--opacity", one(&O::least_opacity)},
        {"--kinds", [](O& o, const std::string& text) { o.kinds = kinds_named(text); }},
        {"--set", [](O& o, const std::string& text) { o.set(text); }}};
    return table;
}

}  // namespace

TruthOptions::TruthOptions() {
    for (const LineKind kind : {LineKind::Laplacian, LineKind::Ridge, LineKind::Crease})
        kinds[kind] = true;
}

PrecomputeOptions TruthOptions::field_options(double diagonal) const {
    PrecomputeOptions options = field;
    for (const auto& [row, percent] : field_percents)
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
        of_style->set(style, number(value));
    } else if (!of_field) {
        throw std::invalid_argument("there is no option '" + key + "'");
    } else if (of_field->kind == OptionKind::Length && !value.empty() && value.back() == '%') {
        value.pop_back();
        field_percents.emplace_back(of_field, number(value));
    } else {
        of_field->set(field, number(value));
    }
}

TruthOptions parse_truth_options(const std::vector<std::string>& arguments) {
    TruthOptions options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i].empty() || arguments[i][0] != '-') {
            options.files.push_back(arguments[i]);
            continue;
        }
        const auto setter = setters().find(arguments[i]);
        if (setter == setters().end())
            throw std::invalid_argument("unknown option " + arguments[i]);
        if (++i == arguments.size())
            throw std::invalid_argument(arguments[i - 1] + " wants a value");
        setter->second(options, arguments[i]);
    }
    if (options.reach == 0 || options.drawing_reach == 0)
        throw std::invalid_argument("no line is within 0");
    validate(options.style);
    validate(options.field_options(1));
    return options;
}

}  // namespace benchmarks
