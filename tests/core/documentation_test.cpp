// SPDX-License-Identifier: GPL-3.0-or-later
// Documents name what the tables of the code have.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "laplacian_lines/line_kind.h"
#include "test_paths.h"

namespace {

using namespace laplacian_lines;

std::string content(const std::string& file) {
    std::ifstream stream(test_paths::repository() / file);
    std::ostringstream text;
    text << stream.rdbuf();
    EXPECT_FALSE(text.str().empty()) << file;
    return text.str();
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Documented, NumbersOfKinds) {
    std::string numbers;
    for (const LineKindDescription& row : kLineKinds)
        numbers += (numbers.empty() ? "" : ", ") + std::to_string(int(row.kind)) + " " + row.one;
    EXPECT_TRUE(contains(content("docs/script.md"), "`ll_kind` (" + numbers + ")")) << numbers;
}

}  // namespace
