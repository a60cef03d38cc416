// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_choice.h"

#include <gtest/gtest.h>

namespace {

using laplacian_lines::LineKind;
using laplacian_lines::LineKindDescription;
using line_renderer::LineLook;

LineChoice colorful() {
    LineChoice choice;
    choice.color = QColor(1, 2, 3, 90);
    choice.outline_color = QColor(4, 5, 6);
    choice.width = 3;
    choice.outline_factor = 2.5;
    return choice;
}

TEST(LineChoice, IsTheUsualLooksByDefault) {
    const line_renderer::LineLooks looks = looksOf(LineChoice()),
                                   usual = line_renderer::usualLooks();
    for (std::size_t i = 0; i < looks.size(); ++i) {
        EXPECT_EQ(looks[i].color, usual[i].color);
        EXPECT_DOUBLE_EQ(looks[i].width, usual[i].width);
    }
}

TEST(LineChoice, FillsTheLooksByWhatIsAnOutline) {
    const line_renderer::LineLooks looks = looksOf(colorful());
    for (const LineKindDescription& kind : laplacian_lines::line_kinds) {
        const auto& model = describe(kind.is_outline ? LineKind::Contour : LineKind::Laplacian);
        if (kind.color != model.color || kind.width != model.width) continue;  // see below
        const LineLook& look = looks[std::size_t(kind.kind)];
        EXPECT_EQ(look.color, kind.is_outline ? QColor(4, 5, 6) : QColor(1, 2, 3, 90)) << kind.key;
        EXPECT_DOUBLE_EQ(look.width, kind.is_outline ? 7.5 : 3) << kind.key;
    }
}

TEST(LineChoice, KeepsTheWidthsOfKindsInProportion) {
    LineKindDescription inside = describe(LineKind::Ridge);
    inside.width = 0.5;
    EXPECT_DOUBLE_EQ(lookOf(inside, colorful()).width, 1.5);
    LineKindDescription outline = describe(LineKind::Border);
    outline.width = 2 * describe(LineKind::Contour).width;
    EXPECT_DOUBLE_EQ(lookOf(outline, colorful()).width, 15);
    EXPECT_EQ(lookOf(outline, colorful()).color, QColor(4, 5, 6));
}

/// Colored kinds, and those with another than their default color.
TEST(LineChoice, LeavesKindsTheirOwnColor) {
    LineChoice choice = colorful();
    EXPECT_EQ(lookOf(describe(LineKind::ApparentRidge), choice).color,
              QColor(describe(LineKind::ApparentRidge).key_color));
    EXPECT_EQ(lookOf(describe(LineKind::Valley), choice).color, QColor(1, 2, 3, 90));
    choice.own[std::size_t(LineKind::Valley)] = Qt::green;
    EXPECT_EQ(lookOf(describe(LineKind::Valley), choice).color, QColor(Qt::green));
    choice.colored = {};
    EXPECT_EQ(lookOf(describe(LineKind::ApparentRidge), choice).color, QColor(1, 2, 3, 90));
    choice.colored[LineKind::Ridge] = true;
    EXPECT_EQ(lookOf(describe(LineKind::Ridge), choice).color,
              QColor(describe(LineKind::Ridge).key_color));
}

TEST(LineChoice, MayHaveOutlinesWithoutWidth) {
    LineChoice choice;
    choice.outline_factor = 0;
    EXPECT_EQ(lookOf(describe(LineKind::Contour), choice).width, 0);
    EXPECT_GT(lookOf(describe(LineKind::Laplacian), choice).width, 0);
}

}  // namespace
