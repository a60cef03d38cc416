// SPDX-License-Identifier: GPL-3.0-or-later
// The tables that dialogs, scripts and range checks are made from.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "laplacian_lines/option_table.h"

namespace {

using namespace laplacian_lines;

template <class Options>
const std::vector<OptionRow<Options>>& table();
template <>
const std::vector<OptionRow<PrecomputeOptions>>& table() {
    return precompute_option_table();
}
template <>
const std::vector<OptionRow<LineStyle>>& table() {
    return line_style_table();
}

template <class Options>
class OptionTable : public testing::Test {};
using BothStructs = testing::Types<PrecomputeOptions, LineStyle>;
TYPED_TEST_SUITE(OptionTable, BothStructs);

TYPED_TEST(OptionTable, KeysAreUniqueIdentifiers) {
    std::set<std::string> keys, labels;
    for (const auto& row : table<TypeParam>()) {
        EXPECT_TRUE(keys.insert(row.key).second) << row.key;
        EXPECT_TRUE(labels.insert(row.label).second) << row.label;
        EXPECT_EQ(std::string(row.key).find_first_not_of("abcdefghijklmnopqrstuvwxyz_"),
                  std::string::npos)
            << row.key;
    }
}

TYPED_TEST(OptionTable, DefaultsAreInsideTheLimits) {
    EXPECT_NO_THROW(validate(TypeParam()));
    for (const auto& row : table<TypeParam>()) {
        EXPECT_LT(row.minimum, row.maximum) << row.key;
        EXPECT_GE(row.get(TypeParam()), row.minimum) << row.key;
        EXPECT_LE(row.get(TypeParam()), row.maximum) << row.key;
    }
}

TYPED_TEST(OptionTable, ChoicesHaveOneNameEach) {
    for (const auto& row : table<TypeParam>()) {
        if (row.kind != OptionKind::Choice) {
            EXPECT_TRUE(row.choices.empty()) << row.key;
            continue;
        }
        EXPECT_EQ(row.minimum, 0) << row.key;
        EXPECT_EQ(row.maximum + 1, double(row.choices.size())) << row.key;
        EXPECT_EQ(std::set<std::string>(row.choices.begin(), row.choices.end()).size(),
                  row.choices.size())
            << row.key;
    }
}

TYPED_TEST(OptionTable, ValuesMakeTheRoundTripAlone) {
    for (const auto& row : table<TypeParam>())
        for (double value : {row.minimum, row.maximum < 1e300 ? row.maximum : 12.5}) {
            TypeParam options;
            row.set(options, value);
            EXPECT_EQ(row.get(options), value) << row.key;
            EXPECT_NO_THROW(validate(options)) << row.key;
            for (const auto& other : table<TypeParam>())
                if (&other != &row) {
                    EXPECT_EQ(other.get(options), other.get(TypeParam())) << row.key << other.key;
                }
        }
}

/// No dialog could set a member without a row. Only as many names as members compile; two of the
/// first are for programs, one of the second is all kinds.
TEST(OptionTables, DescribeEveryMember) {
    [[maybe_unused]] const auto [A, B, C, D, E, F, G, H, I, J, K, L, M] = PrecomputeOptions();
    EXPECT_EQ(precompute_option_table().size(), 13u - 2);
    [[maybe_unused]] const auto [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v,
                                 w, x, y, z] = LineStyle();
    EXPECT_EQ(line_style_table().size(), 26 - 1 + kLineKindCount);
}

}  // namespace
