// SPDX-License-Identifier: GPL-3.0-or-later
// What the dialog of drawings makes of texts and sizes; the dialog itself: gui_drawing_dialog.sh.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>

#include "kept_settings.h"
#include "line_drawing/view_frame.h"
#include "mesh_unit.h"
#include "view_words.h"

namespace {

TEST(ViewWords, AreWhatTheTextNames) {
    EXPECT_TRUE(hasView("front, TOP", "top"));
    EXPECT_TRUE(hasView("six", "bottom"));
    EXPECT_FALSE(hasView("six", "vessel"));
    EXPECT_FALSE(hasView("", "front"));
    EXPECT_EQ(withView("", "front", true), "front");
    EXPECT_EQ(withView("front", "front", true), "front");
    EXPECT_EQ(withView("front; 30 15 left", "front", false), "30,15, left");
    EXPECT_EQ(withView("six", "front", false), "back, left, right, top, bottom");
    EXPECT_EQ(withView("-30,-15,what", "top", true), "-30,-15, what, top");
    EXPECT_EQ(withView("30", "top", true), "30, top");
}

TEST(ViewWords, AreViews) {
    line_drawing::NamedViews window;
    window[window_view] = line_drawing::frameOfSide(line_drawing::Side::Front, {});
    for (const QString& view : viewsWithMarks())
        EXPECT_EQ(line_drawing::parseViews(view, {}, window).size(), 1u) << view.toStdString();
}

TEST(MeshUnits, AreThoseThatScansUsuallyHave) {
    const auto unit = [](double diagonal) {
        return QString(mesh_units[likelyUnit(diagonal)].name);
    };
    EXPECT_EQ(unit(0.05), "m");  // a coin of photogrammetry
    EXPECT_EQ(unit(1.8), "m");   // a statue
    EXPECT_EQ(unit(6), "m");     // a trench
    EXPECT_EQ(unit(15), "mm");   // a bead of a scanner
    EXPECT_EQ(unit(1800), "mm");
}

class KeptSettings : public ::testing::Test {
protected:
    KeptSettings() {
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
        QCoreApplication::setOrganizationName("laplacian-lines-test");
        fresh_.file = "/finds/b_drawing.svg";
    }

    QString kept(const QString& key, const QString& mesh) const {
        for (const DrawingField& field : keptSettings(fresh_, mesh))
            if (field.key == key) return field.text;
        return "none";
    }

    QTemporaryDir folder_;
    DrawingParameters fresh_;
};

TEST_F(KeptSettings, AreNoneAtFirst) {
    EXPECT_TRUE(keptSettings(fresh_, "/finds/a.ply").empty());
}

TEST_F(KeptSettings, OfAnotherMeshAreThoseOfTheUser) {
    DrawingParameters applied;
    applied.file = "/plates/17.pdf";
    applied.views = "left";
    applied.title = "Find 17";
    applied.paper = 3;
    applied.unit = 2;
    applied.has_furniture = false;
    keepSettings(applied, "/finds/a.ply");
    const QString same = "/finds/a.ply", other = "/finds/b.ply";
    for (const QString& mesh : {same, other}) {
        EXPECT_EQ(kept("views", mesh), "left");
        EXPECT_EQ(kept("paper", mesh), "a2");
        EXPECT_EQ(kept("furniture", mesh), "off");
    }
    EXPECT_EQ(kept("file", same), "/plates/17.pdf");
    EXPECT_EQ(kept("title", same), "Find 17");
    EXPECT_EQ(kept("unit", same), "m");
    EXPECT_EQ(kept("file", other), "/finds/b_drawing.pdf");
    EXPECT_EQ(kept("title", other), "");
    EXPECT_EQ(kept("unit", other), "mm");
    EXPECT_EQ(kept("title", ""), "");
}

}  // namespace
