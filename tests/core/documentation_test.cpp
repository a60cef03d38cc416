// SPDX-License-Identifier: GPL-3.0-or-later
// Documents and examples name what the tables of the code have.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include "laplacian_lines/line_kind.h"
#include "laplacian_lines/option_table.h"
#include "places.h"

namespace {

using namespace laplacian_lines;

std::string content(const std::string& file) {
    std::ifstream stream(places::repository() / file);
    std::ostringstream text;
    text << stream.rdbuf();
    EXPECT_FALSE(text.str().empty()) << file;
    return text.str();
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Each row of a table of options has one in docs/parameters.md, perhaps under a heading.
template <class Options>
void expect_rows(const std::vector<OptionDescription<Options>>& table) {
    const std::string text = content("docs/parameters.md");
    for (const auto& row : table)
        EXPECT_EQ(contains(text, std::string("| ") + row.label + " |") ||
                      contains(text, std::string(":** ") + row.label + " |"),
                  !row.instead)
            << row.label;
}

TEST(Documented, OptionsOfTheField) {
    expect_rows(precompute_option_table());
    const std::string example = content("docs/examples/laplacian_lines.mlx");
    for (const auto& row : precompute_option_table())
        EXPECT_TRUE(contains(example, std::string("\"") + row.key + "\"")) << row.key;
}

TEST(Documented, OptionsOfTheStyle) {
    expect_rows(line_style_table());
    const std::string example = content("docs/examples/laplacian_lines_polylines.mlx");
    for (const auto& row : line_style_table()) {
        const bool is_usual_kind =
            std::any_of(line_kinds.begin(), line_kinds.end(), [&](const LineKindDescription& kind) {
                return kind.shown && std::string(kind.key) == row.key;
            });
        EXPECT_EQ(contains(example, std::string("\"") + row.key + "\""),
                  is_usual_kind || !row.for_experts)
            << row.key;
    }
}

TEST(Documented, NumbersOfKinds) {
    std::string numbers;
    for (const LineKindDescription& row : line_kinds)
        numbers += (numbers.empty() ? "" : ", ") + std::to_string(int(row.kind)) + " " + row.one;
    EXPECT_TRUE(contains(content("docs/parameters.md"), "`ll_kind` (" + numbers + ")")) << numbers;
}

}  // namespace
