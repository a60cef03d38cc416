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

constexpr double largest_scale = 1e9;  // and one in as many

/// By what it is the unit of, mm.
struct LengthUnit {
    const char* name;
    double mm, below;
};
constexpr LengthUnit length_units[] = {
    {" µm", 1e-3, 0.1}, {" mm", 1, 1e4}, {" m", 1e3, 1e7}, {" km", 1e6, 0}};

std::string rounded(double x) {
    if (x < 0.0995) return inDigits(std::round(1000 * x) / 1000);
    return inDecimals(x, x < 10 ? 2 : x < 1000 ? 1 : 0);
}

[[noreturn]] void refuseWord(const SheetOption& option, const std::string& word,
                             const std::string& allowed) {
    laplacian_lines::refuse_value(option.command(), "\"" + word + "\"", allowed);
}

laplacian_lines::LineKindSet kindsIn(const std::string& names) {
    if (const auto kinds = laplacian_lines::kinds_named(names)) return *kinds;
    refuse("--kinds is \"" + names + "\". It has to be some of " +
           laplacian_lines::names_of_kinds() + ", with commas between.");
}

/// At most `width` characters a line, indented but for the first.
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

double parseScale(std::string_view text) {
    if (lower(std::string(trimmed(text))) == "fit") return 0;
    const std::size_t colon = std::min(text.find(':'), text.size());
    const double drawn = numberIn(text.substr(0, colon)).value_or(0);
    const double real = numberIn(text.substr(std::min(colon + 1, text.size()))).value_or(0);
    const double scale = drawn / real;
    if (!(drawn > 0) || !(real > 0) || !(scale >= 1 / largest_scale && scale <= largest_scale))
        refuse(
            "\"" + std::string(text) +
            "\" is not a scale. A scale is drawn to true length, such as 1:2 or 2:1, or fit: the "
            "largest usual one.");
    return scale;
}

DetailSize parseDetailSize(std::string_view text) {
    const std::string word = lower(std::string(trimmed(text)));
    if (word == "auto") return {};
    const bool is_share = endsWith(word, "%");
    const std::size_t unit = is_share ? 1 : endsWith(word, "mm") ? 2 : 0;
    const double size = numberIn(word.substr(0, word.size() - unit)).value_or(0);
    if (unit == 0 || !(size >= 1e-3 && size <= 100))
        refuse("\"" + std::string(text) +
               "\" is not a size of detail. Say auto, a length on paper such as 1mm, or a share of "
               "the object's diagonal such as 0.9%.");
    return {is_share ? size / 100 : size, is_share};
}

std::string scaleInWords(double scale) {
    constexpr int digits = 9;
    return scale < 1 ? "1:" + inDigits(1 / scale, digits) : inDigits(scale, digits) + ":1";
}

std::string sizeInWords(const Eigen::Vector3d& mm, const char* times) {
    const double longest = mm.maxCoeff() > 0 ? mm.maxCoeff() : 1;
    const LengthUnit* unit = length_units;
    while (unit + 1 != std::end(length_units) && longest >= unit->below)
        ++unit;
    Words sides;
    for (int axis = 0; axis < 3; ++axis)
        sides.push_back(rounded(mm[axis] / unit->mm));
    return joined(sides, times) + unit->name;
}

std::string kernelInWords(double mm) {
    return mm < 100 ? inDigits(mm, 2) : inDecimals(mm, 0);
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

std::string SheetOption::valueIn(const SheetChoices& choices) const {
    if (row.text) return choices.*row.text;
    const double value = row.get(choices);
    const Words known = words();
    return std::size_t(value) < known.size() ? known[std::size_t(value)] : inDigits(value);
}

void SheetOption::read(const std::string& word, SheetChoices& choices) const {
    if (row.text) {
        choices.*row.text = adds_up ? choices.*row.text + ' ' + word : word;
        return;
    }
    if (const Words known = words(); !known.empty()) {
        const auto place = std::find(known.begin(), known.end(), lower(word));
        if (place == known.end()) refuseWord(*this, word, "one of " + joined(known, ", "));
        return row.set(choices, double(place - known.begin()));
    }
    const std::optional<double> value = numberIn(word);
    if (!value || !(*value >= row.minimum && *value <= row.maximum))
        refuseWord(*this, word, laplacian_lines::allowed_values(row));
    row.set(choices, *value);
}

const SheetOption* commandOption(const std::string& command) {
    for (const SheetOption& option : sheetOptionTable())
        if (option.isOf(SheetOption::Place::Command) && option.command() == command) return &option;
    return nullptr;
}

SheetChoices readChoices(const Words& words) {
    SheetChoices choices;
    const std::string usual_views = std::exchange(choices.views, "");
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
        const SheetOption* option = commandOption(words[i]);
        if (!option) refuse("unknown option " + words[i] + "; see --help.");
        option->read(words[i + 1], choices);
    }
    if (choices.views.empty() && trimmed(choices.sections).empty()) choices.views = usual_views;
    return choices;
}

std::string titleOf(std::string title, const Words& names) {
    constexpr std::string_view place = "{name}";
    const std::string name = joined(names, ", ");
    for (std::size_t at = 0; (at = title.find(place, at)) != title.npos; at += name.size())
        title.replace(at, place.size(), name);
    return title;
}

std::string sheetOptionsHelp() {
    constexpr std::size_t column = 23, width = 90;
    std::string help;
    for (const SheetOption& option : sheetOptionTable()) {
        if (!option.isOf(SheetOption::Place::Command)) continue;
        const Words words = option.words();
        const std::string value =
            option.row.text ? option.form
            : words.empty() ? inDigits(option.row.minimum) + ".." + inDigits(option.row.maximum)
                            : joined(words, "|");
        const std::string head = "  " + option.command() + ' ' + value;
        const std::string usual = option.valueIn({});
        const std::string text = option.row.help + (usual.empty() ? usual : " (" + usual + ')');
        help += head.size() < column ? head : head + '\n';
        help += std::string(head.size() < column ? column - head.size() : column, ' ');
        help += wrapped(text, column, width) + '\n';
    }
    return help;
}

SheetOptions sheetOptions(const SheetChoices& chosen, const NamedViews& others) {
    SheetOptions options;
    static_cast<SheetLook&>(options) = chosen.look;
    options.sections = parseSections(chosen.sections);
    if (!trimmed(chosen.views).empty() || options.sections.empty())
        options.views = parseViews(chosen.views, chosen.look.up, others);
    options.scale = parseScale(chosen.scale);
    const std::vector<const char*> papers = paperNames();
    const auto paper = std::size_t(chosen.paper);
    options.paper = paper < papers.size() ? papers[paper] : "fit";
    options.mm_per_unit = mesh_units[chosen.unit].mm;
    if (!formatOf(chosen.file).has_tapered_strokes) options.strokes = StrokeStyle::Plain;
    options.title = chosen.title;
    options.pens = pensOf(chosen.weights);
    options.kernel = parseDetailSize(chosen.kernel);
    options.smoothing = parseDetailSize(chosen.smoothing);
    options.style.shows = kindsIn(chosen.kinds);
    options.style.detail = chosen.detail;
    return options;
}

}  // namespace line_drawing
