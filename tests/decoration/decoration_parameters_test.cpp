// SPDX-License-Identifier: GPL-3.0-or-later
// The decoration's parameters as MeshLab gets them, their values read back, and those that other
// versions have kept.
#include "decoration_parameters.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextDocument>
#include <cmath>
#include <set>

#include "meshlab_host/camera.h"

namespace {

using laplacian_lines::LineKind;
using line_renderer::HiddenLines;

RichEnum choice(const char* key, int value) {
    return {kDecorationPrefix + key, value, QStringList(), "", ""};
}

RichFloat number(const char* key, double value) {
    return {kDecorationPrefix + key, float(value), "", ""};
}

RichBool tick(const char* key, bool is_on) {
    return {kDecorationPrefix + key, is_on, "", ""};
}

RichParameterList listed() {
    RichParameterList list;
    list_decoration_parameters(list);
    return list;
}

TEST(DecorationParameters, AreFewHaveNamesOfTheirOwnAndToolTipsThatWrap) {
    std::set<QString> names;
    const RichParameterList list = listed();
    for (const RichParameter& parameter : list) {
        EXPECT_TRUE(parameter.name().startsWith(kDecorationPrefix));
        EXPECT_TRUE(names.insert(parameter.name()).second) << parameter.name().toStdString();
        EXPECT_TRUE(Qt::mightBeRichText(parameter.toolTip())) << parameter.name().toStdString();
    }
    EXPECT_LE(names.size(), 18u);
}

TEST(DecorationParameters, AreTheDefaultsWhenNothingIsSet) {
    const DecorationParameters defaults, read = read_valid_parameters(listed()).chosen;
    EXPECT_EQ(read.drawing_style, DrawingStyle::Custom);
    for (const auto& kind : laplacian_lines::kLineKinds) {
        const line_renderer::LineLook& look = read.appearance.looks[std::size_t(kind.kind)];
        EXPECT_EQ(look.color, QColor(Qt::black));
        EXPECT_DOUBLE_EQ(look.width, line_renderer::kUsualLineWidth * kind.width);
        EXPECT_DOUBLE_EQ(look.share_within, kind.bounds_form ? 0.7 : 1);
        EXPECT_EQ(read.style.shows[kind.kind], kind.shown) << kind.key;
    }
    EXPECT_EQ(read.surface, SurfaceLook::AsMeshLabDrawsIt);
    EXPECT_FALSE(light_azimuth(read));
    EXPECT_EQ(read.appearance.hidden, HiddenLines::LeftOut);
    EXPECT_EQ(read.at_rest, AtRest::PrintedDrawing);
    EXPECT_EQ(read.style.detail, defaults.style.detail);
    EXPECT_EQ(read.style.gradient_threshold, defaults.style.gradient_threshold);
    EXPECT_EQ(read.style.strength_threshold, defaults.style.strength_threshold);
    EXPECT_FALSE(read.show_statistics);
}

TEST(DecorationParameters, WidenOutlinesInProportion) {
    RichParameterList list;
    list.addParam(number("line_width", 3));
    list.addParam(number("contour_width_factor", 2.5));
    const DecorationParameters read = read_valid_parameters(list).chosen;
    for (const auto& kind : laplacian_lines::kLineKinds)
        EXPECT_DOUBLE_EQ(read.appearance.looks[std::size_t(kind.kind)].width,
                         kind.bounds_form ? 7.5 : 3)
            << kind.key;
}

TEST(DecorationParameters, DrawingStylesOverrideColorSurfaceAndLight) {
    for (int style : {1, 2})
        for (int light : {0, 3}) {
            RichParameterList list;
            list.addParam(choice("drawing_style", style));
            list.addParam(choice("surface", int(SurfaceLook::Toon)));
            list.addParam(choice("light", light));
            list.addParam(choice("hidden_lines", 2));
            list.addParam(number("detail", 70));
            list.addParam(RichColor(kDecorationPrefix + "line_color", Qt::red, "", ""));
            const DecorationParameters read = read_valid_parameters(list).chosen;
            for (const line_renderer::LineLook& look : read.appearance.looks)
                EXPECT_EQ(look.color, QColor(Qt::black));
            EXPECT_EQ(read.surface, SurfaceLook::Paper);
            EXPECT_EQ(read.light, style == 1 ? kAtTheEye : std::max(light, kFromTheUpperLeft));
            EXPECT_EQ(read.appearance.hidden, HiddenLines::Dashed);
            EXPECT_EQ(read.style.detail, 70);
        }
}

TEST(DecorationParameters, HaveLightsAroundThePicture) {
    const std::vector<Eigen::Vector2d> directions = {{-1, 1}, {0, 1},  {1, 1},   {1, 0},
                                                     {1, -1}, {0, -1}, {-1, -1}, {-1, 0}};
    for (std::size_t i = 0; i < directions.size(); ++i) {
        RichParameterList list;
        list.addParam(choice("light", kFromTheUpperLeft + int(i)));
        const auto azimuth = light_azimuth(read_valid_parameters(list).chosen);
        ASSERT_TRUE(azimuth);
        const Eigen::Vector3d light = meshlab_host::towards_light(*azimuth);
        EXPECT_TRUE(light.head<2>().normalized().isApprox(directions[i].normalized(), 1e-12)) << i;
        EXPECT_NEAR(light.z(), std::sqrt(0.5), 1e-12);
    }
}

TEST(DecorationParameters, MixturesOverrideTicksAndSayWhichKindsHaveTheirOwnColor) {
    for (int style : {0, 1})
        for (std::size_t i = 0; i < laplacian_lines::kLineMixtures.size(); ++i) {
            const laplacian_lines::LineMixture& wanted = laplacian_lines::kLineMixtures[i];
            RichParameterList list;
            list.addParam(choice("drawing_style", style));
            list.addParam(choice("lines", int(i) + 1));
            list.addParam(tick("contours", false));
            const DecorationParameters read = read_valid_parameters(list).chosen;
            const bool has_colors =  // Publication is black but for the mixture that tells all
                                     // kinds apart by color
                style == 0 || wanted.colored == laplacian_lines::kinds_with_key_color();
            for (const auto& kind : laplacian_lines::kLineKinds) {
                EXPECT_EQ(read.style.shows[kind.kind], wanted.kinds[kind.kind])
                    << wanted.key << ": " << kind.key;
                EXPECT_EQ(read.appearance.looks[std::size_t(kind.kind)].color,
                          has_colors && wanted.colored[kind.kind] ? QColor(kind.key_color)
                                                                  : QColor(Qt::black))
                    << wanted.key << ": " << kind.key;
            }
        }
}

TEST(DecorationParameters, OutOfRangeStayAsTheyWereAndAreNamed) {
    RichParameterList good_list, list;
    good_list.addParam(number("line_width", 3));
    const ValidParameters good = read_valid_parameters(good_list);
    EXPECT_TRUE(good.refused.empty());
    list.addParam(number("line_width", 0));
    list.addParam(number("laplacian_lines", NAN));
    list.addParam(number("detail", 70));
    const ValidParameters once = read_valid_parameters(list, good.as_set);
    for (const ValidParameters& read : {once, read_valid_parameters(list, once.as_set)}) {
        ASSERT_EQ(read.refused.size(), 2);
        EXPECT_EQ(read.refused[0],
                  "\"Line Width\" is 0. It has to be between 0.1 and 64. Until then it stays 3.");
        EXPECT_EQ(read.chosen.line_width, 3);
        EXPECT_EQ(read.chosen.appearance.looks[0].width, 3);
        EXPECT_TRUE(read.chosen.style.shows[LineKind::Laplacian]);
        EXPECT_EQ(read.chosen.style.detail, 70) << "others count";
    }
    EXPECT_EQ(read_valid_parameters(list).chosen.line_width, DecorationParameters().line_width)
        << "there was no last time";
}

TEST(DecorationParameters, OfOtherVersionsAreNamedOnce) {
    const QTemporaryDir folder;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
    QCoreApplication::setOrganizationName("laplacian-lines-test");
    QSettings settings;
    for (const char* key : {"detail", "fading", "tones"})
        settings.setValue(kDecorationPrefix + key, "<Param/>");
    settings.setValue("MeshLab::Decoration::Fading", "<Param/>");
    EXPECT_EQ(forget_other_settings(), "Settings of another version are ignored: fading, tones.");
    EXPECT_EQ(forget_other_settings(), "");
    EXPECT_EQ(settings.allKeys().size(), 2);
}

}  // namespace
