// SPDX-License-Identifier: GPL-3.0-or-later
// The table of kinds, and what has to hold for each.
#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "fixed/fixed_kinds.h"
#include "helpers.h"
#include "laplacian_lines/option_table.h"
#include "laplacian_lines/precompute.h"
#include "redraw/kinds/strip_kinds.h"

namespace laplacian_lines {

/// For GoogleTest's output.
void PrintTo(const LineKindDescription& row, std::ostream* out) {
    *out << row.key;
}

}  // namespace laplacian_lines

namespace {

using namespace laplacian_lines;
using test_meshes::MeshEntry;
using test_meshes::meshes_with;
using test_meshes::TestMesh;

class EachKind : public testing::TestWithParam<LineKindDescription> {
protected:
    LineKind kind() const { return GetParam().kind; }
};
INSTANTIATE_TEST_SUITE_P(Kinds, EachKind, testing::ValuesIn(line_kinds),
                         [](const auto& info) { return std::string(info.param.key); });

LineStyle only(LineKind kind) {
    LineStyle style;
    style.shows = LineKindSet();
    style.shows[kind] = true;
    style.detail = 100;
    style.ridge_angle = kind == LineKind::Valley ? 5 : 10;
    style.crease_angle = 20;
    return style;
}

LineExtractor extractor_of(const TestMesh& mesh) {
    PrecomputeOptions options;
    options.curvature_derivatives = true;
    return {mesh.mesh, precompute(mesh.mesh, options)};
}

TEST(LineKinds, AreInTheOrderOfTheirNumbers) {
    for (std::size_t i = 0; i < line_kind_count; ++i)
        EXPECT_EQ(std::size_t(line_kinds[i].kind), i) << line_kinds[i].key;
}

TEST(LineKinds, HaveNamesOfTheirOwn) {
    for (const auto name : {&LineKindDescription::key, &LineKindDescription::label,
                            &LineKindDescription::one, &LineKindDescription::many}) {
        std::set<std::string> names;
        for (const LineKindDescription& row : line_kinds) {
            EXPECT_GT(std::strlen(row.*name), 3u);
            EXPECT_TRUE(names.insert(row.*name).second) << row.*name;
        }
    }
}

TEST(LineKinds, AreEachFoundInOneWay) {
    std::multiset<LineKind> found;
    for (unsigned i = 0; i < kStripKindCount; ++i) {
        EXPECT_EQ(strip_kinds()[i]->kind, kStripKinds[i]);
        EXPECT_TRUE(describe(kStripKinds[i]).depends_on_view);
        found.insert(kStripKinds[i]);
    }
    for (const FixedKind* kind : fixed_kinds()) {
        EXPECT_FALSE(describe(kind->kind).depends_on_view);
        found.insert(kind->kind);
    }
    for (const LineKindDescription& row : line_kinds)
        EXPECT_EQ(found.count(row.kind), 1u) << row.key;
    EXPECT_EQ(found.size(), line_kind_count);
}

TEST_P(EachKind, HasItsSwitchInTheOptions) {
    for (const auto& row : line_style_table()) {
        if (std::strcmp(row.key, GetParam().key) != 0) continue;
        EXPECT_EQ(row.kind, OptionKind::Boolean);
        LineStyle style;
        EXPECT_EQ(row.get(style) != 0, GetParam().shown);
        for (const bool on : {true, false}) {
            row.set(style, on);
            EXPECT_EQ(style.shows[kind()], on);
            EXPECT_EQ(row.get(style) != 0, on);
        }
        return;
    }
    FAIL() << "no switch " << GetParam().key;
}

TEST_P(EachKind, IsDrawnAloneWhereItIsSwitchedOnAlone) {
    std::size_t count = 0;
    for (const MeshEntry& entry : test_meshes::all_entries()) {
        const TestMesh& mesh = entry.get();
        const LineExtractor extractor = extractor_of(mesh);
        const LineSet lines =
            helpers::extract(extractor, View::perspective(Eigen::Vector3d(3, 2, 4)), only(kind()));
        for (const Polyline& line : lines.lines)
            EXPECT_EQ(line.kind, kind()) << mesh.name;
        count += lines.lines.size();
        if (count > 0) return;
    }
    FAIL() << "no mesh has a line of this kind";
}

/// Some with borders, some with edges.
std::vector<const MeshEntry*> some_meshes() {
    std::vector<const MeshEntry*> some;
    for (const auto& meshes : {meshes_with(test_meshes::kBorder), meshes_with(test_meshes::kSharp)})
        some.insert(some.end(), meshes.begin(), meshes.begin() + 2);
    return some;
}

TEST_P(EachKind, FollowsTheEyeIfItSaysSo) {
    bool follows = false;
    for (const MeshEntry* entry : some_meshes()) {
        const TestMesh* mesh = &entry->get();
        const LineExtractor extractor = extractor_of(*mesh);
        const auto lines_from = [&](const Eigen::Vector3d& eye) {
            LineStyle style = only(kind());
            style.contour_clearance = 0;
            return helpers::extract(extractor, View::perspective(eye), style);
        };
        const bool same = helpers::same_lines(lines_from({30, 2, 4}), lines_from({3, 20, 40}));
        EXPECT_TRUE(same || GetParam().depends_on_view) << mesh->name;
        follows = follows || !same;
    }
    EXPECT_EQ(follows, GetParam().depends_on_view);
}

}  // namespace
