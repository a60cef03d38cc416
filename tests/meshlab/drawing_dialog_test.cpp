// SPDX-License-Identifier: GPL-3.0-or-later
// The drawing dialog's texts and sizes; the dialog itself: gui_drawing_dialog.gui.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <map>

#include "drawing_dialog.h"
#include "line_drawing/view_frame.h"

namespace {

TEST(DrawingViews, AreWhatTheTextNames) {
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

TEST(DrawingViews, ThatHaveMarksAreViews) {
    line_drawing::NamedViews window;
    window[window_view] = line_drawing::frameOfSide(line_drawing::Side::Front, {});
    for (const QString& view : viewsWithMarks())
        EXPECT_EQ(line_drawing::parseViews(view.toStdString(), {}, window).size(), 1u) << view.toStdString();
}

TEST(DrawingUnits, AreThoseThatScansUsuallyHave) {
    const auto unit = [](double diagonal) {
        return QString(line_drawing::mesh_units[likelyUnit(diagonal)].name);
    };
    EXPECT_EQ(unit(0.05), "m");  // a coin of photogrammetry
    EXPECT_EQ(unit(1.8), "m");   // a statue
    EXPECT_EQ(unit(6), "m");     // a trench
    EXPECT_EQ(unit(15), "mm");   // a bead of a scanner
    EXPECT_EQ(unit(1800), "mm");
}

class DrawingSettings : public ::testing::Test {
protected:
    DrawingSettings() {
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

TEST_F(DrawingSettings, AreNoneAtFirst) {
    EXPECT_TRUE(keptSettings(fresh_, "/finds/a.ply").empty());
}

TEST_F(DrawingSettings, OfAnotherMeshAreThoseOfTheUser) {
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

/// 40 x 30 units.
struct OneTriangle {
    MeshDocument document;
    MeshModel* layer = document.addNewMesh("/finds/find.ply", "find");

    OneTriangle() {
        auto vertex = vcg::tri::Allocator<CMeshO>::AddVertices(layer->cm, 3);
        vertex[0].P() = Point3m(0, 0, 0);
        vertex[1].P() = Point3m(40, 0, 0);
        vertex[2].P() = Point3m(0, 30, 0);
        vcg::tri::Allocator<CMeshO>::AddFace(layer->cm, 0, 1, 2);
        vcg::tri::UpdateBounding<CMeshO>::Box(layer->cm);
    }
};

TEST(DrawingOutlook, FollowsFieldsAndLayers) {
    OneTriangle scene;
    DrawingOutlook outlook;
    std::map<QString, QString> fields;
    const auto words = [&] {
        return outlook
            .inWords(scene.document,
                     [&](const QString& label) {
                         const auto field = fields.find(label);
                         return field == fields.end() ? std::nullopt
                                                      : std::optional<QString>(field->second);
                     })
            .value_or("busy")
            .toStdString();
    };
    EXPECT_EQ(words(), "1 unit = 1 mm: the object is 40.0 × 30.0 × 0 mm in size. Fits A4 at 5:1.");
    fields["Unit of the Mesh"] = "cm";
    EXPECT_EQ(words(), "1 unit = 1 cm: the object is 400.0 × 300.0 × 0 mm in size. Fits A4 at 1:2.");
    fields["Scale"] = "1:1";
    EXPECT_EQ(
        words().find("1 unit = 1 cm: the object is 400.0 × 300.0 × 0 mm in size. At the scale "), 0u);
    fields["Scale"] = "fit";
    scene.layer->cm.Tr.SetScale(10, 10, 10);
    EXPECT_EQ(words(), "1 unit = 1 cm: the object is 4000 × 3000 × 0 mm in size. Fits A4 at 1:20.");
    scene.document.setBusy(true);
    EXPECT_EQ(words(), "busy");
    scene.document.setBusy(false);
    scene.document.setVisible(int(scene.layer->id()), false);
    fields["Layers"] = "All Visible Layers";
    EXPECT_EQ(words().find("There is nothing to draw."), 0u);
}

}  // namespace
