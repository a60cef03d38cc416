// SPDX-License-Identifier: GPL-3.0-or-later
// The decoration's parameters as MeshLab gets them, and their values read back.
#include <gtest/gtest.h>

#include <cmath>

#include <QTextDocument>

#include <set>

#include "decoration_parameters.h"
#include "laplacian_lines/option_table.h"

namespace {

using laplacian_lines::LineKind;
using line_renderer::HiddenLines;
using line_renderer::SurfaceAppearance;

const QString kPrefix = "MeshLab::Decoration::LaplacianLines_";

RichEnum choice(const char* key, int value) {
    return {kPrefix + key, value, {"0", "1", "2"}, "", ""};
}

RichFloat number(const char* key, double value) {
    return {kPrefix + key, float(value), "", ""};
}

QStringList listedKeys() {
    RichParameterList list;
    listDecorationParameters(list);
    QStringList keys;
    for (const RichParameter& parameter : list) {
        EXPECT_TRUE(parameter.name().startsWith(kPrefix));
        keys << parameter.name().mid(kPrefix.size());
    }
    return keys;
}

TEST(DecorationParameters, HaveNamesOfTheirOwn) {
    const QStringList keys = listedKeys();
    EXPECT_EQ(std::set<QString>(keys.begin(), keys.end()).size(), std::size_t(keys.size()));
}

TEST(DecorationParameters, BeginWithWhatEverybodyUses) {
    const QStringList keys = listedKeys();
    ASSERT_GT(keys.size(), 20);
    EXPECT_EQ(keys[0], "drawing_style");
    EXPECT_EQ(keys[1], "lines");
    EXPECT_EQ(keys[2], "detail");
    EXPECT_LT(keys.indexOf("light_elevation"), keys.indexOf("gradient_threshold"));
    EXPECT_LT(keys.indexOf("line_width"), keys.indexOf("gradient_threshold"));
    EXPECT_LT(keys.indexOf("contours"), keys.indexOf("laplacian_lines"));
    EXPECT_EQ(keys.indexOf("ridges") + 1, keys.indexOf("ridge_angle"));
    EXPECT_EQ(keys.indexOf("creases") + 1, keys.indexOf("crease_angle"));
}

TEST(DecorationParameters, HaveAllOptionsOfTheStyle) {
    const QStringList keys = listedKeys();
    for (const auto& row : laplacian_lines::line_style_table())
        EXPECT_EQ(keys.contains(row.key), !row.instead) << row.key;
}

/// Qt breaks the lines of rich text only.
TEST(DecorationParameters, HaveToolTipsThatWrap) {
    RichParameterList list;
    listDecorationParameters(list);
    for (const RichParameter& parameter : list)
        EXPECT_TRUE(Qt::mightBeRichText(parameter.toolTip())) << parameter.name().toStdString();
}

/// A check box would show the markup of a heading.
TEST(DecorationParameters, HaveNoHeadingOverSwitches) {
    RichParameterList list;
    listDecorationParameters(list);
    int headings = 0;
    for (const RichParameter& parameter : list) {
        if (!parameter.fieldDescription().contains('<')) continue;
        ++headings;
        EXPECT_FALSE(parameter.value().isBool()) << parameter.name().toStdString();
    }
    EXPECT_EQ(headings, 3);
}

TEST(DecorationParameters, AreTheDefaultsWhenNothingIsSet) {
    RichParameterList list;
    listDecorationParameters(list);
    const DecorationParameters defaults, read = readValidParameters(list).chosen;
    EXPECT_EQ(read.drawing_style, DrawingStyle::Custom);
    for (std::size_t kind = 0; kind < laplacian_lines::line_kind_count; ++kind) {
        EXPECT_EQ(read.appearance.looks[kind].color, defaults.appearance.looks[kind].color);
        EXPECT_EQ(read.appearance.looks[kind].width, defaults.appearance.looks[kind].width);
    }
    EXPECT_EQ(read.surface.style, defaults.surface.style);
    EXPECT_EQ(read.surface.tones, defaults.surface.tones);
    EXPECT_EQ(read.surface.shade, defaults.surface.shade);
    EXPECT_EQ(read.background, defaults.background);
    EXPECT_EQ(read.light, defaults.light);
    EXPECT_EQ(read.camera_light.azimuth, defaults.camera_light.azimuth);
    EXPECT_EQ(read.camera_light.elevation, defaults.camera_light.elevation);
    EXPECT_EQ(read.style.line_slope, defaults.style.line_slope);
    EXPECT_EQ(read.show_statistics, defaults.show_statistics);
}

TEST(DecorationParameters, DrawingStylesOverrideColorsPaperAndLight) {
    for (int style : {1, 2}) {
        RichParameterList list;
        list.addParam(choice("drawing_style", style));
        list.addParam(choice("surface", SurfaceAppearance::Toon));
        list.addParam(choice("light", style == 1 ? 1 : 0));
        list.addParam(choice("hidden_lines", 2));
        list.addParam(number("line_width", 3));
        list.addParam(number("detail", 70));
        list.addParam(number("light_azimuth", 20));
        for (const char* key : {"line_color", "contour_color", "paper_color"})
            list.addParam(RichColor(kPrefix + key, QColor(255, 0, 0, 90), "", ""));
        const DecorationParameters read = readValidParameters(list).chosen;
        for (const line_renderer::LineLook& look : read.appearance.looks)
            EXPECT_EQ(look.color, QColor(Qt::black));
        EXPECT_EQ(read.surface.style, SurfaceAppearance::Paper);
        EXPECT_EQ(read.surface.paper, QColor(Qt::white));
        EXPECT_EQ(read.background, Background::Paper);
        EXPECT_EQ(read.light, style == 1 ? Light::AtTheEye : Light::FixedToTheCamera);
        EXPECT_EQ(read.appearance.hidden, HiddenLines::Dashed);
        EXPECT_EQ(read.appearance.looks[0].width, 3);
        EXPECT_EQ(read.style.detail, 70);
        EXPECT_EQ(read.camera_light.azimuth, 20);
    }
}

/// Settings of older versions keep counting.
TEST(DecorationParameters, SwitchesCountByDefault) {
    RichParameterList list;
    list.addParam(RichBool(kPrefix + "laplacian_lines", false, "", ""));
    list.addParam(RichBool(kPrefix + "valleys", true, "", ""));
    const DecorationParameters read = readValidParameters(list).chosen;
    EXPECT_EQ(mixtureOf(read), nullptr);
    EXPECT_FALSE(read.style.shows[LineKind::Laplacian]);
    EXPECT_TRUE(read.style.shows[LineKind::Valley]);
}

RichEnum mixture(int value) {
    return {kPrefix + "lines", value, QStringList(), "", ""};
}

TEST(DecorationParameters, MixturesOverrideSwitchesOfKinds) {
    for (std::size_t i = 0; i < laplacian_lines::line_mixtures.size(); ++i) {
        const laplacian_lines::LineMixture& wanted = laplacian_lines::line_mixtures[i];
        RichParameterList list;
        list.addParam(mixture(int(i) + 1));
        list.addParam(RichBool(kPrefix + "valleys", true, "", ""));
        list.addParam(RichBool(kPrefix + "contours", false, "", ""));
        list.addParam(number("detail", 70));
        const DecorationParameters read = readValidParameters(list).chosen;
        EXPECT_EQ(mixtureOf(read), &wanted);
        EXPECT_EQ(read.style.detail, 70);
        for (const auto& kind : laplacian_lines::line_kinds)
            EXPECT_EQ(read.style.shows[kind.kind], wanted.kinds[kind.kind])
                << wanted.key << ": " << kind.key;
    }
}

/// Colored, or as all other lines.
TEST(DecorationParameters, MixturesSayWhichKindsHaveTheirOwnColor) {
    for (int style : {0, 1})
        for (std::size_t i = 0; i < laplacian_lines::line_mixtures.size(); ++i) {
            const laplacian_lines::LineMixture& wanted = laplacian_lines::line_mixtures[i];
            RichParameterList list;
            list.addParam(mixture(int(i) + 1));
            list.addParam(choice("drawing_style", style));
            const DecorationParameters read = readValidParameters(list).chosen;
            const bool has_colors =  // Publication is black, but for what is shown in its colors
                style == 0 || wanted.colored == laplacian_lines::kinds_with_key_color();
            for (const auto& kind : laplacian_lines::line_kinds)
                EXPECT_EQ(read.appearance.looks[std::size_t(kind.kind)].color,
                          has_colors && wanted.colored[kind.kind] ? QColor(kind.key_color)
                                                                  : QColor(Qt::black))
                    << wanted.key << ": " << kind.key;
        }
}

TEST(DecorationParameters, OutOfRangeStayAsTheyWereAndAreNamed) {
    RichParameterList good_list, list;
    good_list.addParam(number("line_width", 3));
    const ValidParameters good = readValidParameters(good_list);
    EXPECT_TRUE(good.refused.empty());
    list.addParam(number("line_width", 0));
    list.addParam(number("detail", 70));
    const ValidParameters once = readValidParameters(list, good.as_set);
    for (const ValidParameters& read : {once, readValidParameters(list, once.as_set)}) {
        ASSERT_EQ(read.refused.size(), 1u);
        EXPECT_EQ(read.refused.at("line_width"),
                  "\"Line Width\" is 0. It has to be between 0.1 and 64. Until then it stays 3.");
        EXPECT_EQ(read.chosen.lines.width, 3);
        EXPECT_EQ(read.chosen.appearance.looks[0].width, good.chosen.appearance.looks[0].width);
        EXPECT_EQ(read.chosen.style.detail, 70) << "others count";
    }
    EXPECT_EQ(readValidParameters(list).chosen.lines.width, DecorationParameters().lines.width)
        << "there was no last time";
}

TEST(DecorationParameters, OutOfRangeStayAsTheyWereSet) {
    for (std::size_t i = 0; i < laplacian_lines::line_mixtures.size(); ++i) {
        RichParameterList before, list;
        before.addParam(mixture(int(i) + 1));
        list.addParam(number("laplacian_lines", NAN));
        const ValidParameters read = readValidParameters(list, readValidParameters(before).as_set);
        EXPECT_EQ(read.refused.size(), 1u);
        EXPECT_TRUE(read.chosen.style.shows[LineKind::Laplacian]);
    }
}

}  // namespace
