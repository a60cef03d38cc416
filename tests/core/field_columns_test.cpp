// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the field's columns, and the documentation that has to follow it and that of kinds.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/line_kind.h"
#include "test_paths.h"

namespace {

using namespace laplacian_lines;

/// As in docs: "`ll_normal`" or "`ll_shape_diagonal`, `ll_shape_off_diagonal`".
std::string documented_names(const FieldColumn& column) {
    std::string names;
    for (const FieldAttribute& attribute : column.attributes)
        if (attribute.floats > 0)
            names += (names.empty() ? "`" : ", `") + std::string(attribute.name) + "`";
    return names;
}

std::string all_documents() {
    std::string text;
    for (const auto& entry : std::filesystem::directory_iterator(test_paths::repository() / "docs"))
        if (entry.path().extension() == ".md") text += test_paths::content(entry.path());
    return text;
}

TEST(FieldColumns, HaveAttributesForAllFloats) {
    std::set<std::string> names;
    for (const FieldColumn& column : kFieldColumns) {
        EXPECT_TRUE(names.insert(column.key).second) << column.key;
        int floats = 0;
        for (const FieldAttribute& attribute : column.attributes) {
            floats += attribute.floats;
            if (attribute.floats == 0) continue;
            EXPECT_TRUE(attribute.floats == 3 || attribute.floats == 1);
            EXPECT_TRUE(names.insert(attribute.name).second) << attribute.name;
            EXPECT_EQ(std::string(attribute.name).rfind("ll_", 0), 0u) << attribute.name;
        }
        EXPECT_EQ(floats, column.floats) << column.key;
    }
}

TEST(FieldColumns, AreDocumented) {
    const std::string documents = all_documents();
    for (const FieldColumn& column : kFieldColumns) {
        const std::size_t row = documents.find("| " + documented_names(column) + " |");
        ASSERT_NE(row, std::string::npos) << column.key;
        const std::string text = documents.substr(row, documents.find('\n', row) - row);
        EXPECT_NE(text.find(column.help), std::string::npos) << text;
        EXPECT_NE(text.find(column.unit), std::string::npos) << text;
    }
}

TEST(LineKinds, HaveTheirNumbersDocumented) {
    std::string numbers;
    for (const LineKindDescription& row : kLineKinds)
        numbers += (numbers.empty() ? "" : ", ") + std::to_string(int(row.kind)) + " " + row.one;
    const std::string document = test_paths::content("docs/script.md");
    EXPECT_NE(document.find("`ll_kind` (" + numbers + ")"), std::string::npos) << numbers;
}

}  // namespace
