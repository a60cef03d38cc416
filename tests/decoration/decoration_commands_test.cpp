// SPDX-License-Identifier: GPL-3.0-or-later
// The GUI driver's commands for named parameters and pictures of a comparison.
#include "decoration_settings.h"

#include <gtest/gtest.h>

#include "laplacian_lines/error.h"
#include "laplacian_lines/line_mixture.h"

namespace {

std::string commands(const QStringList& settings) {
    return settingCommands(settings).join("; ").toStdString();
}

TEST(SettingCommands, ReleaseWhatWouldOverrideThem) {
    EXPECT_EQ(commands({"Detail=70"}), "setdeco Detail = 70");
    EXPECT_EQ(commands({"ridges=off", "Laplacian Lines=off", "Line Color=red"}),
              "setdeco Lines = Laplacian Lines, as Switched; setdeco Drawing Style = Custom; "
              "setdeco Ridges = off; setdeco Laplacian Lines = off; setdeco Line Color = #ff0000");
}

TEST(SettingCommands, LeaveWhatIsNamedItself) {
    EXPECT_EQ(commands({"lines=apparent", "ridges=off"}),
              "setdeco Lines = Apparent Ridges; setdeco Ridges = off");
}

std::vector<ComparedPicture> pictures(const QString& names, const QStringList& settings = {}) {
    return comparedPictures(names, settings);
}

TEST(ComparedPictures, OfAllAreTheMixturesAndTheEdgesOfPictures) {
    const auto all = pictures("all");
    ASSERT_EQ(all.size(), laplacian_lines::line_mixtures.size() + 1);
    EXPECT_EQ(all.front().label, "Laplacian Lines");
    EXPECT_EQ(all.back().detector, "canny");
    for (const ComparedPicture& picture : all)
        EXPECT_FALSE(picture.before.isEmpty()) << picture.label.toStdString();
}

TEST(ComparedPictures, AreMixturesOrSwitchedKinds) {
    const auto two = pictures("apparent_ridges, ridges+photic_extrema");
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(two[0].before, QStringList{"setdeco Lines = Apparent Ridges"});
    EXPECT_TRUE(two[0].after.isEmpty());
    const QStringList& switched = two[1].before;
    EXPECT_EQ(switched.front(), "setdeco Lines = Laplacian Lines, as Switched");
    EXPECT_TRUE(switched.contains("setdeco Ridges = on"));
    EXPECT_TRUE(switched.contains("setdeco Photic Extremum Lines = on"));
    EXPECT_TRUE(switched.contains("setdeco Occluding Contours = on"));
    EXPECT_TRUE(switched.contains("setdeco Laplacian Lines = off"));
}

/// And undo their own changes.
TEST(ComparedPictures, HaveHighlightsOnDarkPaperUnlessItsColorIsSet) {
    const auto lights = pictures("suggestive_contours_and_highlights").front();
    ASSERT_EQ(lights.before.size(), 3);
    EXPECT_EQ(lights.after,
              (QStringList{"setdeco Paper Color = #ffffff", "setdeco Highlight Color = #d08a1d"}));
    for (const char* setting : {"Paper Color=blue", "Highlight Color=red"})
        EXPECT_TRUE(pictures("suggestive_highlights", {setting}).front().after.isEmpty());
    EXPECT_TRUE(pictures("all_kinds").front().after.isEmpty());
}

TEST(ComparedPictures, OfEdgesShowTheSurfaceWithoutLines) {
    for (const char* detector : {"log", "canny"}) {
        const auto picture = pictures(detector).front();
        EXPECT_EQ(picture.detector, detector);
        for (const auto& kind : laplacian_lines::line_kinds)
            EXPECT_TRUE(picture.before.contains(QString("setdeco %1 = off").arg(kind.label)));
        EXPECT_TRUE(picture.before.contains("setdeco Surface = As MeshLab Draws It"));
        EXPECT_EQ(picture.after, QStringList{"setdeco Surface = Paper"});
    }
}

TEST(ComparedPictures, OfUnknownNamesListThose) {
    for (const char* names : {"", "ridge", "log,", "log+ridges"})
        try {
            pictures(names);
            ADD_FAILURE() << names << " is taken";
        } catch (const laplacian_lines::Error& error) {
            EXPECT_NE(std::string(error.what()).find("ridges_and_valleys, "), std::string::npos);
        }
}

}  // namespace
