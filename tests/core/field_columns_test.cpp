// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the field's columns, and the documentation that has to follow it.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "laplacian_lines/error.h"
#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "places.h"
#include "registry.h"

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

std::vector<std::string> documentation_lines() {
    namespace fs = std::filesystem;
    std::vector<fs::path> files = {places::repository() / "README.md"};
    for (const auto& entry : fs::directory_iterator(places::repository() / "docs"))
        if (entry.path().extension() == ".md") files.push_back(entry.path());
    std::vector<std::string> lines;
    for (const fs::path& path : files) {
        std::ifstream file(path);
        for (std::string line; std::getline(file, line);)
            lines.push_back(line);
        lines.emplace_back();  // tables do not go on in the next file
    }
    return lines;
}

/// Of the table with the first column's attributes, without its heading.
std::vector<std::string> attribute_rows() {
    const std::string first = "| " + documented_names(field_columns[0]) + " |";
    const auto is_row = [](const std::string& line) { return line.rfind("| `", 0) == 0; };
    std::vector<std::string> rows;
    const std::vector<std::string> lines = documentation_lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].rfind(first, 0) != 0) continue;
        while (i > 0 && is_row(lines[i - 1]))
            --i;
        for (; is_row(lines[i]); ++i)
            rows.push_back(lines[i]);
    }
    return rows;
}

TEST(FieldColumns, NamesAreUniqueIdentifiers) {
    std::set<std::string> names;
    for (const FieldColumn& column : field_columns) {
        EXPECT_TRUE(names.insert(column.key).second) << column.key;
        for (const FieldAttribute& attribute : column.attributes) {
            if (attribute.floats == 0) continue;
            EXPECT_TRUE(names.insert(attribute.name).second) << attribute.name;
            EXPECT_EQ(std::string(attribute.name).rfind("ll_", 0), 0u) << attribute.name;
        }
    }
    for (const std::string& name : names)
        EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos) << name;
}

TEST(FieldColumns, AttributesHoldAllFloats) {
    for (const FieldColumn& column : field_columns) {
        int floats = 0;
        for (const FieldAttribute& attribute : column.attributes) {
            EXPECT_TRUE(attribute.floats == 3 || attribute.floats == 1 || attribute.floats == 0);
            floats += attribute.floats;
        }
        EXPECT_EQ(floats, column.floats) << column.key;
    }
}

TEST(FieldColumns, FunctionsReachTheVectors) {
    Field field;
    for (const FieldColumn& column : field_columns) {
        column.resize(field, 2);
        ASSERT_EQ(column.size(field), 2u) << column.key;
        for (int i = 0; i < 2 * column.floats; ++i)
            column.write(field)[i] = float(column.floats * 100 + i);
        EXPECT_EQ(column.read(field), column.write(field));
    }
    ASSERT_TRUE(field.normals.size() == 2 && field.laplacian_normals.size() == 2);
    EXPECT_EQ(field.normals[1], Eigen::Vector3f(303, 304, 305));
    EXPECT_EQ(field.laplacian_normals[0], Eigen::Vector3f(300, 301, 302));
    const ShapeOperator& s = field.shape_operators.at(1);
    EXPECT_EQ(std::vector<float>({s.xx, s.yy, s.zz, s.yz, s.xz, s.xy}),
              std::vector<float>({606, 607, 608, 609, 610, 611}));
    EXPECT_EQ(field.kernel_sizes.at(1), 101);
}

TEST(FieldColumns, WhatIsComputedHasAllThatAreNotOptional) {
    const auto mesh = test_meshes::mesh_named("torus").mesh;
    const Field field = precompute(mesh);
    for (const FieldColumn& column : field_columns) {
        if (column.optional && column.size(field) == 0) continue;
        ASSERT_EQ(column.size(field), mesh.positions.size()) << column.key;
        const std::size_t count = std::size_t(column.floats) * column.size(field);
        float largest = 0;
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_TRUE(std::isfinite(column.read(field)[i])) << column.key;
            largest = std::max(largest, std::abs(column.read(field)[i]));
        }
        EXPECT_GT(largest, 0) << column.key;
    }
}

TEST(FieldColumns, EachHasToFitTheMesh) {
    const auto mesh = test_meshes::mesh_named("single_triangle").mesh;
    for (const FieldColumn& column : field_columns)
        for (const int more : {-1, 1}) {
            Field field = precompute(mesh);
            column.resize(field, mesh.positions.size() + std::size_t(more));
            EXPECT_FALSE(has_entries(field, mesh.positions.size())) << column.key;
            try {
                const LineExtractor extractor(mesh, field);
                ADD_FAILURE() << column.key;
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), ErrorCode::FieldMismatch) << column.key;
            }
        }
}

TEST(FieldColumns, OptionalOnesMayBeAbsentButNotShort) {
    std::vector<FieldColumn> table(field_columns.begin(), field_columns.end());
    FieldColumn& sizes = table.at(3);
    ASSERT_EQ(std::string(sizes.key), "kernel_sizes");
    sizes.optional = true;
    Field field;
    for (const FieldColumn& column : table)
        column.resize(field, 3);
    EXPECT_EQ(present_columns(field, table).size(), table.size());
    EXPECT_TRUE(has_entries(field, 3, table));
    field.kernel_sizes.resize(2);
    EXPECT_FALSE(has_entries(field, 3, table));
    field.kernel_sizes.clear();
    EXPECT_EQ(present_columns(field, table).size(), table.size() - 1);
    EXPECT_TRUE(has_entries(field, 3, table));
    EXPECT_FALSE(has_entries(field, 3));  // the real table has it always
}

TEST(FieldColumns, AreDocumented) {
    const std::vector<std::string> rows = attribute_rows();
    ASSERT_EQ(rows.size(), field_columns.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const FieldColumn& column = field_columns[i];
        EXPECT_EQ(rows[i].rfind("| " + documented_names(column) + " |", 0), 0u) << rows[i];
        EXPECT_NE(rows[i].find(column.help), std::string::npos) << rows[i];
        EXPECT_NE(rows[i].find(column.unit), std::string::npos) << rows[i];
    }
}

}  // namespace
