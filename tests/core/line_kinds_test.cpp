// SPDX-License-Identifier: GPL-3.0-or-later
// The table of kinds, what has to hold for each, and where there is nothing to draw.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <set>
#include <string>

#include "helpers.h"
#include "laplacian_lines/option_table.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;

TEST(LineKinds, AreInTheOrderOfTheirNumbers) {
    for (std::size_t i = 0; i < kLineKindCount; ++i)
        EXPECT_EQ(std::size_t(kLineKinds[i].kind), i) << kLineKinds[i].key;
}

TEST(LineKinds, HaveNamesOfTheirOwn) {
    for (const auto name : {&LineKindDescription::key, &LineKindDescription::label,
                            &LineKindDescription::one, &LineKindDescription::many}) {
        std::set<std::string> names;
        for (const LineKindDescription& row : kLineKinds) {
            EXPECT_GT(std::strlen(row.*name), 3u);
            EXPECT_TRUE(names.insert(row.*name).second) << row.*name;
        }
    }
}

TEST(LineKinds, HaveASwitchInTheOptions) {
    for (const LineKindDescription& kind : kLineKinds) {
        const auto& table = line_style_table();
        const auto row = std::find_if(table.begin(), table.end(), [&](const auto& option) {
            return std::string(option.key) == kind.key;
        });
        ASSERT_NE(row, table.end()) << kind.key;
        EXPECT_EQ(row->kind, OptionKind::Boolean);
        LineStyle style;
        EXPECT_EQ(row->get(style) != 0, kind.shown);
        for (const bool on : {true, false}) {
            row->set(style, on);
            EXPECT_EQ(style.shows[kind.kind], on) << kind.key;
        }
    }
}

/// On surfaces with borders and with edges.
TEST(LineKinds, AreDrawnAloneAndFollowTheEyeUnlessTheyLieOnTheSurface) {
    std::array<std::size_t, kLineKindCount> count{};
    std::array<bool, kLineKindCount> follows{};
    for (const char* name : {"hills", "half_torus", "three_sheets", "rounded_cube"}) {
        const TriangleMesh& mesh = test_meshes::mesh_named(name).mesh;
        const LineExtractor extractor(mesh, helpers::complete_field(mesh));
        for (const LineKindDescription& row : kLineKinds) {
            LineStyle style = helpers::only(row.kind);
            style.detail = 100;
            style.ridge_angle = row.kind == LineKind::Valley ? 5 : 10;
            style.crease_angle = 20;
            style.contour_clearance = 0;
            const LineSet lines = helpers::extract(extractor, View::perspective({30, 2, 4}), style);
            for (const Polyline& line : lines.lines)
                EXPECT_EQ(line.kind, row.kind) << name;
            count[std::size_t(row.kind)] += lines.lines.size();
            follows[std::size_t(row.kind)] |= !helpers::same_lines(
                lines, helpers::extract(extractor, View::perspective({3, 20, 40}), style));
        }
    }
    for (const LineKindDescription& row : kLineKinds) {
        EXPECT_GT(count[std::size_t(row.kind)], 0u) << row.key;
        EXPECT_NE(follows[std::size_t(row.kind)], helpers::lies_on_the_surface(row.kind))
            << row.key;
    }
}

/// Without the help of thresholds, but for photic extrema.
TEST(ViewKinds, DrawNothingOnASphere) {
    const auto sphere = test_meshes::sphere(5);
    const LineExtractor extractor(sphere.mesh, helpers::complete_field(sphere.mesh));
    std::size_t photic = 0;
    for (const View& view : helpers::random_views(sphere.mesh, 10)) {
        const LineSet all =
            helpers::extract(extractor, view, helpers::all_crossings_of_all_kinds());
        for (const Polyline& line : all.lines) {
            photic += line.kind == LineKind::PhoticExtremum;
            for (const LineKind kind : {LineKind::SuggestiveContour, LineKind::SuggestiveHighlight,
                                        LineKind::ApparentRidge})
                EXPECT_NE(line.kind, kind) << describe(kind).key;
        }
        const LineStyle style = helpers::only(LineKind::PhoticExtremum);
        EXPECT_TRUE(helpers::extract(extractor, view, style).lines.empty());
    }
    EXPECT_GT(photic, 5u);
}

TEST(ViewKinds, AreLeftOutWhereTheyAreFlat) {
    const auto surface = test_meshes::bumpy_sphere(4, 0.15);
    const LineExtractor extractor(surface.mesh, helpers::complete_field(surface.mesh));
    const View view = View::perspective({3, 2, 4});
    for (const auto& [kind, slope] :
         {std::pair(LineKind::SuggestiveContour, &LineStyle::suggestive_slope),
          {LineKind::SuggestiveHighlight, &LineStyle::suggestive_slope},
          {LineKind::ApparentRidge, &LineStyle::apparent_slope},
          {LineKind::PhoticExtremum, &LineStyle::photic_slope}}) {
        LineStyle style = helpers::all_crossings_of_all_kinds();
        style.shows = helpers::only(kind).shows;
        EXPECT_FALSE(helpers::extract(extractor, view, style).lines.empty());
        style.*slope = 1e6;
        EXPECT_TRUE(helpers::extract(extractor, view, style).lines.empty()) << describe(kind).key;
    }
}

TEST(ViewKinds, DrawNothingOnAPlane) {
    const TriangleMesh& plane = test_meshes::mesh_named("plane").mesh;
    const LineExtractor extractor(plane, helpers::complete_field(plane));
    for (const View& view : helpers::random_views(plane, 10))
        for (const LineKind kind : {LineKind::SuggestiveContour, LineKind::SuggestiveHighlight,
                                    LineKind::ApparentRidge, LineKind::PhoticExtremum})
            EXPECT_EQ(helpers::extract(extractor, view, helpers::only(kind)).lines.size(), 0u)
                << describe(kind).key;
}

}  // namespace
