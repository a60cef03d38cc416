// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of the decoration as people write them.
#include "decoration_settings.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>

#include "decoration_table.h"
#include "laplacian_lines/error.h"

namespace {

/// "LABEL = VALUE", or why it is refused.
std::string read(const char* text) {
    try {
        const DecorationSetting setting = readDecorationSetting(text);
        return (setting.label + " = " + setting.value).toStdString();
    } catch (const laplacian_lines::Error& error) {
        return error.what();
    }
}

TEST(DecorationSettings, GoByLabelsAndKeys) {
    for (const char* text : {"Detail=70", "detail = 70", " DETAIL =70", "Detail=7e1"})
        EXPECT_EQ(read(text), "Detail = 70") << text;
    EXPECT_EQ(read("line_width=2.5"), "Line Width = 2.5");
    EXPECT_EQ(read("Gradient Threshold t=0.7"), "Gradient Threshold t = 0.7");
}

TEST(DecorationSettings, AreNumbersWithinTheirLimits) {
    for (const char* value : {"abc", "", "-1", "101", "nan", "inf", "7 0", "0x10", "70%"})
        EXPECT_EQ(read((std::string("Detail=") + value).c_str()),
                  std::string("\"Detail\" is ") + value + ". It has to be between 0 and 100.");
    EXPECT_EQ(read("Detail=0"), "Detail = 0");
    EXPECT_EQ(read("Detail=100"), "Detail = 100");
    EXPECT_EQ(read("Tones=3"), "Tones = 3");
    EXPECT_EQ(read("Line Width=0,5"),
              "\"Line Width\" is 0,5. It has to be between 0.1 and 64, with a decimal point.");
    EXPECT_EQ(read("Tones=3.5"), "\"Tones\" is 3.5. It has to be a whole number, between 2 and 8.");
}

TEST(DecorationSettings, AreSwitches) {
    for (const char* value : {"on", "yes", "True", "1"})
        EXPECT_EQ(read((std::string("ridges=") + value).c_str()), "Ridges = on");
    for (const char* value : {"OFF", "no", "false", "0"})
        EXPECT_EQ(read((std::string("Ridges=") + value).c_str()), "Ridges = off");
    EXPECT_EQ(read("Ridges=2"), "\"Ridges\" is 2. It has to be on or off.");
}

TEST(DecorationSettings, AreChoicesByTextBeginningOrNumber) {
    EXPECT_EQ(read("Hidden Lines=dashed"), "Hidden Lines = Dashed");
    EXPECT_EQ(read("drawing_style=pub"), "Drawing Style = Publication (Black on White)");
    EXPECT_EQ(read("Hidden Lines=1"), "Hidden Lines = Faint");
    const std::string allowed = " It has to be one of 0 (Left Out), 1 (Faint), 2 (Dashed).";
    for (const char* value : {"3", "-1", "x", ""})
        EXPECT_EQ(read((std::string("Hidden Lines=") + value).c_str()),
                  std::string("\"Hidden Lines\" is ") + value + "." + allowed);
}

TEST(DecorationSettings, AreColors) {
    EXPECT_EQ(read("Line Color=#202020"), "Line Color = #202020");
    EXPECT_EQ(read("paper_color=Red"), "Paper Color = #ff0000");
    EXPECT_EQ(read("Line Color=reddish"),
              "\"Line Color\" is reddish. It has to be a color, such as #202020 or gray.");
}

/// All that the layer dialog shows can be set.
TEST(DecorationSettings, ThatAreUnknownNameAllOthers) {
    EXPECT_EQ(read("Detial=70").find("The decoration has no parameter \"Detial\"."), 0u);
    EXPECT_EQ(read("Detail").find("\"Detail\" has no value."), 0u);
    for (const char* text : {"Detial=70", "Detail", "=70"}) {
        const std::string reason = read(text);
        EXPECT_NE(reason.find("Detail (detail): between 0 and 100\n"), std::string::npos);
        RichParameterList list;
        listDecorationParameters(list);
        for (const RichParameter& parameter : list) {
            const QString key = parameter.name().section('_', 1);
            EXPECT_NE(reason.find(("(" + key + "): ").toStdString()), std::string::npos)
                << key.toStdString();
        }
    }
}

TEST(DecorationSettings, ThatWentSayWhatToDo) {
    EXPECT_EQ(
        read("Least Slope of a Line=0.02"),
        "\"Least Slope of a Line\" can no longer be set, it is always 0.012. Detail shows more "
        "or fewer lines of all kinds.");
    EXPECT_EQ(
        read("valley_angle=20"),
        "\"Valley Angle\" can no longer be set, it is always that of ridges. Set Ridge Angle.");
    RichParameterList list;
    listDecorationParameters(list);
    for (const GoneParameter& gone : goneParameters()) {
        EXPECT_FALSE(list.hasParameter(decoration_prefix + gone.key)) << gone.key.toStdString();
        EXPECT_NE(read((gone.key + "=1").toUtf8().constData()).find("can no longer be set"),
                  std::string::npos)
            << gone.key.toStdString();
    }
}

/// MeshLab keeps all parameters when it ends, those with their defaults too.
TEST(DecorationSettings, ThatWentAreNamedWhereMeshLabHasKeptAnotherValue) {
    const QTemporaryDir folder;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
    QCoreApplication::setOrganizationName("laplacian-lines-test");
    EXPECT_TRUE(ignoredSettings().isEmpty());
    QSettings settings;
    const auto keep = [&](const char* key, const char* attributes) {
        settings.setValue(decoration_prefix + key, QString("<Param %1/>").arg(attributes));
    };
    keep("line_slope", "type=\"RichFloat\" value=\"0.012\"");
    keep("exact_outlines", "type=\"RichBool\" value=\"true\"");
    keep("valley_angle", "type=\"RichFloat\" value=\"10\"");
    keep("ridge_color", "type=\"RichColor\" a=\"255\" b=\"42\" g=\"75\" r=\"122\"");
    EXPECT_TRUE(ignoredSettings().isEmpty()) << ignoredSettings().join('\n').toStdString();
    keep("line_slope", "type=\"RichFloat\" value=\"0.02\"");
    keep("exact_outlines", "type=\"RichBool\" value=\"false\"");
    keep("ridge_color", "type=\"RichColor\" a=\"255\" b=\"42\" g=\"75\" r=\"1\"");
    const QString lines = ignoredSettings().join('\n');
    EXPECT_EQ(ignoredSettings().size(), 3);
    EXPECT_TRUE(lines.contains("\"Exact Outlines\" can no longer be set, it is always on."))
        << lines.toStdString();
}

}  // namespace
