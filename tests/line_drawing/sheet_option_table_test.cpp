// SPDX-License-Identifier: GPL-3.0-or-later
// The table of sheet options, what is made from it, and the example of a script that follows it.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "laplacian_lines/error.h"
#include "line_drawing/sheet_choices.h"
#include "sheet_helpers.h"
#include "test_paths.h"

using namespace line_drawing;
using sheet_helpers::has;

namespace {

using Place = SheetOption::Place;

std::vector<SheetOption> options_of(Place place) {
    std::vector<SheetOption> options;
    for (const SheetOption& option : sheet_option_table())
        if (option.is_of(place)) options.push_back(option);
    return options;
}

std::string complaint(const SheetOption& option, const std::string& word) {
    SheetChoices choices;
    try {
        option.read(word, choices);
    } catch (const laplacian_lines::Error& error) {
        return error.what();
    }
    return {};
}

TEST(SheetOptions, HaveNamesOfTheirOwn) {
    std::set<std::string> keys, labels, commands;
    for (const SheetOption& option : sheet_option_table()) {
        EXPECT_TRUE(keys.insert(option.row.key).second) << option.row.key;
        EXPECT_TRUE(labels.insert(option.row.label).second) << option.row.label;
        EXPECT_TRUE(commands.insert(option.command()).second) << option.row.key;
        EXPECT_TRUE(ends_with(option.row.help, ".")) << option.row.key;
        EXPECT_EQ(option.row.text != nullptr, option.row.get == nullptr) << option.row.key;
    }
}

TEST(SheetOptions, AreReadAsTheyAreWritten) {
    for (const SheetOption& option : options_of(Place::Command))
        for (const std::string& word : option.words()) {
            SheetChoices choices;
            option.read(upper(word), choices);
            EXPECT_EQ(option.value_in(choices), word) << option.row.key;
            for (const SheetOption& other : options_of(Place::Command))
                if (other.row.key != std::string(option.row.key)) {
                    EXPECT_EQ(other.value_in(choices), other.value_in({})) << option.row.key;
                }
        }
}

TEST(SheetOptions, RefuseWhatIsNotAllowedAndSayWhatIs) {
    for (const SheetOption& option : options_of(Place::Command))
        if (!option.words().empty()) {
            EXPECT_EQ(complaint(option, "sideways"), option.command() +
                                                         " is \"sideways\". It has to be one of " +
                                                         joined(option.words(), ", ") + '.')
                << option.row.key;
        }
}

TEST(SheetOptions, AreThoseOfASheetByDefault) {
    const SheetOptions read = sheet_options({}), made;
    EXPECT_EQ(read.paper, made.paper);
    EXPECT_EQ(read.mm_per_unit, made.mm_per_unit);
    EXPECT_EQ(read.scale, made.scale);
    EXPECT_EQ(read.pens, made.pens);
    EXPECT_EQ(read.kernel.size, made.kernel.size);
    EXPECT_EQ(read.smoothing.size, made.smoothing.size);
    EXPECT_TRUE(read.style.shows == made.style.shows);
    EXPECT_EQ(read.has_annotations, made.has_annotations);
}

TEST(SheetOptions, AreInTheHelpWithValuesAndDefault) {
    const std::string help = sheet_options_help();
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 100u) << line;
    EXPECT_TRUE(has(help, "  --wall hatched|filled|none\n")) << help;
    EXPECT_TRUE(has(help, "outline alone. (hatched)\n"));
    EXPECT_FALSE(has(help, "--layers"));
}

/// As in MeshLab's script.
std::string in_script(const SheetOption& option) {
    const SheetOption::Row& row = option.row;
    const std::string begin = std::string("<Param name=\"") + row.key + "\" type=\"";
    if (option.row.text) return begin + "RichString\" value=\"" + option.value_in({}) + "\"/>";
    const double value = row.get({});
    if (row.kind == laplacian_lines::OptionKind::Boolean)
        return begin + "RichBool\" value=\"" + (value != 0 ? "true" : "false") + "\"/>";
    if (row.kind == laplacian_lines::OptionKind::Real)
        return begin + "RichFloat\" value=\"" + in_digits(value) + "\"/>";
    std::string choices = std::to_string(row.choices.size()) + '"';
    for (std::size_t i = 0; i < row.choices.size(); ++i)
        choices += " enum_val" + std::to_string(i) + "=\"" + row.choices[i] + '"';
    return begin + "RichEnum\" value=\"" + in_digits(value) + "\" enum_cardinality=\"" + choices +
           "/>";
}

TEST(SheetOptions, OfTheFilterAreInTheExample) {
    const std::string example = test_paths::content("docs/examples/laplacian_lines_drawing.mlx");
    for (const SheetOption& option : options_of(Place::Filter))
        EXPECT_TRUE(has(example, in_script(option) + '\n')) << in_script(option);
}

}  // namespace
