// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_choices.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "line_drawing/sheet_file.h"
#include "line_drawing/words.h"

namespace line_drawing {
namespace {

constexpr double kLargestScale = 1e9;  // and one in as many

/// A unit, its length in mm and the length in mm below which it is used.
struct LengthUnit {
    const char* name;
    double mm, below;
};
constexpr LengthUnit kLengthUnits[] = {
    {" µm", 1e-3, 0.1}, {" mm", 1, 1e4}, {" m", 1e3, 1e7}, {" km", 1e6, INFINITY}};

/// With three decimals where two would leave one digit; .0995 is .10 with two.
std::string rounded(double x) {
    if (x < 0.0995) return in_digits(std::round(1000 * x) / 1000);
    return in_decimals(x, x < 10 ? 2 : x < 1000 ? 1 : 0);
}

[[noreturn]] void refuse_word(const SheetOption& option, const std::string& word,
                              const std::string& allowed) {
    laplacian_lines::refuse_value(option.command(), "\"" + word + "\"", allowed);
}

laplacian_lines::LineKindSet kinds_in(const std::string& names) {
    if (const auto kinds = laplacian_lines::kinds_named(names)) return *kinds;
    laplacian_lines::refuse_value(
        "--kinds", "\"" + names + "\"",
        "some of " + laplacian_lines::names_of_kinds() + ", with commas between");
}

/// At most `width` bytes a line, unless a word is longer; lines but the first are indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
    std::string result;
    std::size_t column = indent;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        if (column > indent && column + 1 + end - begin > width) {
            result += '\n' + std::string(indent, ' ');
            column = indent;
        } else if (column > indent) {
            result += ' ';
            ++column;
        }
        result += text.substr(begin, end - begin);
        column += end - begin;
        begin = end + 1;
    }
    return result;
}

}  // namespace

double parse_scale(std::string_view text) {
    if (lower(std::string(trimmed(text))) == "fit") return 0;
    const std::size_t colon = std::min(text.find(':'), text.size());
    const double drawn = number_in(text.substr(0, colon)).value_or(0);
    const double real = number_in(text.substr(std::min(colon + 1, text.size()))).value_or(0);
    const double scale = drawn / real;
    if (!(drawn > 0) || !(real > 0) || !(scale >= 1 / kLargestScale && scale <= kLargestScale))
        refuse(
            "\"" + std::string(text) +
            "\" is not a scale. A scale is drawn to true length, such as 1:2 or 2:1, or fit: the "
            "largest usual one.");
    return scale;
}

DetailSize parse_detail_size(std::string_view text) {
    const std::string word = lower(std::string(trimmed(text)));
    if (word == "auto") return {};
    const bool is_share = ends_with(word, "%");
    const std::size_t unit = is_share ? 1 : ends_with(word, "mm") ? 2 : 0;
    const double size = number_in(word.substr(0, word.size() - unit)).value_or(0);
    if (unit == 0 || !(size >= 1e-3 && size <= 100))
        refuse("\"" + std::string(text) +
               "\" is not a size of detail. Say auto, a length on paper such as 1mm, or a share of "
               "the object's diagonal such as 0.9%: 0.001 to 100 of either.");
    return {is_share ? size / 100 : size, is_share};
}

std::string scale_text(double scale) {
    constexpr int digits = 9;
    return scale < 1 ? "1:" + in_digits(1 / scale, digits) : in_digits(scale, digits) + ":1";
}

std::string size_text(const Eigen::Vector3d& mm, const char* times) {
    const double longest = mm.maxCoeff() > 0 ? mm.maxCoeff() : 1;
    const LengthUnit* unit = kLengthUnits;
    while (!(longest < unit->below) && unit + 1 != std::end(kLengthUnits))
        ++unit;
    Words sides;
    for (int axis = 0; axis < 3; ++axis)
        sides.push_back(rounded(mm[axis] / unit->mm));
    return joined(sides, times) + unit->name;
}

std::string kernel_text(double mm) {
    return mm < 99.5 ? in_digits(mm, 2) : in_decimals(mm, 0);  // not 1e+02
}

std::string SheetOption::command() const {
    return std::string("--") + (command_word ? command_word : row.key);
}

Words SheetOption::words() const {
    Words result(switch_words.begin(), switch_words.end());
    if (row.text) return result;
    for (const std::string label : row.choices)
        result.push_back(lower(label.substr(0, label.find(' '))));
    return result;
}

std::string SheetOption::value_in(const SheetChoices& choices) const {
    if (row.text) return choices.*row.text;
    const double value = row.get(choices);
    const Words known = words();
    return std::size_t(value) < known.size() ? known[std::size_t(value)] : in_digits(value);
}

void SheetOption::read(const std::string& word, SheetChoices& choices) const {
    if (row.text) {
        choices.*row.text = is_repeatable ? choices.*row.text + ' ' + word : word;
        return;
    }
    if (const Words known = words(); !known.empty()) {
        const auto place = std::find(known.begin(), known.end(), lower(word));
        if (place == known.end()) refuse_word(*this, word, "one of " + joined(known, ", "));
        return row.set(choices, double(place - known.begin()));
    }
    const std::optional<double> value = number_in(word);
    if (!value || !(*value >= row.minimum && *value <= row.maximum))
        refuse_word(*this, word, laplacian_lines::allowed_values(row));
    row.set(choices, *value);
}

const SheetOption* command_option(const std::string& command) {
    for (const SheetOption& option : sheet_option_table())
        if (option.is_of(SheetOption::Place::Command) && option.command() == command)
            return &option;
    return nullptr;
}

SheetChoices read_choices(const Words& words) {
    SheetChoices choices;
    const std::string usual_views = std::exchange(choices.views, "");
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
        const SheetOption* option = command_option(words[i]);
        if (!option) refuse("unknown option " + words[i] + "; see --help.");
        option->read(words[i + 1], choices);
    }
    if (choices.views.empty() && trimmed(choices.sections).empty()) choices.views = usual_views;
    return choices;
}

std::string title_of(std::string title, const Words& names) {
    constexpr std::string_view place = "{name}";
    const std::string name = joined(names, ", ");
    for (std::size_t at = 0; (at = title.find(place, at)) != title.npos; at += name.size())
        title.replace(at, place.size(), name);
    return title;
}

std::string sheet_options_help() {
    constexpr std::size_t column = 23, width = 90;
    std::string help;
    for (const SheetOption& option : sheet_option_table()) {
        if (!option.is_of(SheetOption::Place::Command)) continue;
        const Words words = option.words();
        const std::string value =
            option.row.text ? option.form
            : words.empty() ? in_digits(option.row.minimum) + ".." + in_digits(option.row.maximum)
                            : joined(words, "|");
        const std::string head = "  " + option.command() + ' ' + value;
        const std::string usual = option.value_in({});
        const std::string text = option.row.help + (usual.empty() ? usual : " (" + usual + ')');
        help += head.size() < column ? head : head + '\n';
        help += std::string(head.size() < column ? column - head.size() : column, ' ');
        help += wrapped(text, column, width) + '\n';
    }
    return help;
}

SheetOptions sheet_options(const SheetChoices& chosen, const NamedViews& others) {
    SheetOptions options;
    static_cast<SheetLook&>(options) = chosen.look;
    options.sections = parse_sections(chosen.sections);
    if (!trimmed(chosen.views).empty() || options.sections.empty())
        options.views = parse_views(chosen.views, chosen.look.up, others);
    options.scale = parse_scale(chosen.scale);
    options.paper = paper_names().at(std::size_t(chosen.paper));
    options.mm_per_unit = kMeshUnits[chosen.unit].mm;
    if (!format_of(chosen.file).has_tapered_strokes) options.strokes = StrokeStyle::Plain;
    options.title = chosen.title;
    options.pens = pens_of(chosen.weights);
    options.kernel = parse_detail_size(chosen.kernel);
    options.smoothing = parse_detail_size(chosen.smoothing);
    options.style.shows = kinds_in(chosen.kinds);
    options.style.detail = chosen.detail;
    return options;
}

}  // namespace line_drawing
