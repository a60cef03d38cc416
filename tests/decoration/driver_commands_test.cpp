// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of the decoration, and kinds to compare, as people write them.
#include "driver_commands.h"

#include <gtest/gtest.h>

#include "decoration_parameters.h"
#include "laplacian_lines/error.h"

namespace {

/// The driver's command, or why it is refused.
std::string read(const std::string& text) {
    try {
        return setting_commands({QString::fromStdString(text)}).join("; ").toStdString();
    } catch (const laplacian_lines::Error& error) {
        return error.what();
    }
}

TEST(DecorationSettings, GoByLabelsAndKeys) {
    for (const char* text : {"Detail=70", "detail = 70", " DETAIL =70", "Detail=7e1"})
        EXPECT_EQ(read(text), "setdeco Detail = 70") << text;
    EXPECT_EQ(read("contour_width_factor=2.5"), "setdeco Outline Width = 2.5");
    EXPECT_EQ(setting_commands({"Detail=0", "ridges=off"}),
              (QStringList{"setdeco Detail = 0", "setdeco Ridges = off"}));
}

TEST(DecorationSettings, AreNumbersWithinTheirLimits) {
    for (const std::string value : {"abc", "", "-1", "101", "nan", "inf", "7 0", "0x10", "70%"})
        EXPECT_EQ(read("Detail=" + value),
                  "\"Detail\" is " + value + ". It has to be between 0 and 100.");
    EXPECT_EQ(read("Line Width=0,5"),
              "\"Line Width\" is 0,5. It has to be between 0.1 and 64, with a decimal point.");
}

TEST(DecorationSettings, AreSwitchesChoicesAndColors) {
    for (const char* value : {"on", "yes", "True", "1"})
        EXPECT_EQ(read(std::string("Ridges=") + value), "setdeco Ridges = on");
    for (const char* value : {"OFF", "no", "false", "0"})
        EXPECT_EQ(read(std::string("Ridges=") + value), "setdeco Ridges = off");
    EXPECT_EQ(read("Ridges=2"), "\"Ridges\" is 2. It has to be on or off.");
    EXPECT_EQ(read("Hidden Lines=dashed"), "setdeco Hidden Lines = Dashed");
    EXPECT_EQ(read("Hidden Lines=1"), "setdeco Hidden Lines = Faint");
    EXPECT_EQ(read("drawing_style=pub"), "setdeco Drawing Style = Publication (Black on White)");
    for (const std::string value : {"3", "-1", "x", ""})
        EXPECT_EQ(read("Hidden Lines=" + value),
                  "\"Hidden Lines\" is " + value +
                      ". It has to be one of 0 (Not Drawn), 1 (Faint), 2 (Dashed).");
    EXPECT_EQ(read("Line Color=Red"), "setdeco Line Color = #ff0000");
    for (const std::string color : {"reddish", "transparent"})
        EXPECT_EQ(
            read("Line Color=" + color),
            "\"Line Color\" is " + color + ". It has to be a color, such as #202020 or gray.");
}

TEST(DecorationSettings, ThatAreUnknownNameAllOthers) {
    EXPECT_EQ(read("Detial=70").find("The decoration has no parameter \"Detial\"."), 0u);
    EXPECT_EQ(read("Detail").find("\"Detail\" has no value."), 0u);
    RichParameterList list;
    list_decoration_parameters(list);
    for (const char* text : {"Detial=70", "Detail", "=70"})
        for (const RichParameter& parameter : list)
            EXPECT_NE(
                read(text).find(("(" + parameter.name().section('_', 1) + "): ").toStdString()),
                std::string::npos)
                << parameter.name().toStdString();
}

TEST(ComparedPictures, OfAllAreTheMixturesButThatOfAllKinds) {
    QList<QStringList> expected, all;
    for (const auto& mixture : laplacian_lines::kLineMixtures)
        if (std::string(mixture.key) != "all_kinds")
            expected << QStringList{QString("setdeco Lines = ") + mixture.label};
    for (const ComparedPicture& picture : compared_pictures("all"))
        all << picture.commands;
    EXPECT_EQ(all, expected);
    EXPECT_EQ(compared_pictures("all").front().label, "Laplacian Lines");
}

TEST(ComparedPictures, AreMixturesOrTickedKinds) {
    const auto two = compared_pictures("apparent_ridges, ridges+creases");
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(two[0].label, "Apparent Ridges");
    EXPECT_EQ(two[1].label, "ridges+creases");
    EXPECT_EQ(two[0].commands, QStringList{"setdeco Lines = Apparent Ridges"});
    EXPECT_EQ(two[1].commands,
              (QStringList{"setdeco Lines = As Ticked Below", "setdeco Laplacian Lines = off",
                           "setdeco Outlines = on", "setdeco Ridges = on", "setdeco Borders = on",
                           "setdeco Creases = on"}));
    EXPECT_TRUE(
        compared_pictures("usual").front().commands.contains("setdeco Laplacian Lines = on"));
}

TEST(ComparedPictures, OfUnknownNamesAreRefusedWithAllThatAreKnown) {
    for (const char* names : {"", "ridge", "ridges,", "valleys", "ridges+valleys"})
        try {
            compared_pictures(names);
            ADD_FAILURE() << names << " is taken";
        } catch (const laplacian_lines::Error& error) {
            for (const auto& mixture : laplacian_lines::kLineMixtures)
                EXPECT_NE(std::string(error.what()).find(std::string(" ") + mixture.key),
                          std::string::npos)
                    << names << ": " << mixture.key;
        }
}

}  // namespace
