// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QStringList>

#include "drawing_parameters.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/line_mixture.h"
#include "meshlab_host/drawn_style.h"

namespace {

using laplacian_lines::Error;
using line_drawing::SheetOptions;
using meshlab_host::CurrentView;

const CurrentView window{true, {0, 0, 9}, {1, 0, 0}, {0, 0, 1}};  // seen from x, z up

line_drawing::Words viewNames(const char* views, const char* sections = "") {
    DrawingParameters chosen;
    chosen.views = views;
    chosen.sections = sections;
    line_drawing::Words names;
    for (const line_drawing::ViewFrame& view : sheetOptions(chosen, window).views)
        names.push_back(view.name);
    return names;
}

TEST(DrawingParameters, ViewsKeepTheirOrder) {
    EXPECT_EQ(line_drawing::joined(viewNames("top, WINDOW;30,15 front"), "/"),
              "Top/View/View 30°, 15°/Front");
    EXPECT_EQ(viewNames("six window").size(), 7u);
    EXPECT_THROW(viewNames(""), Error);
    EXPECT_TRUE(viewNames("", "x=0.5").empty());
    EXPECT_THROW(viewNames("above"), Error);
    EXPECT_THROW(viewNames("30 window"), Error);
    EXPECT_THROW(viewNames("front", "w=0.5"), Error);
}

TEST(DrawingParameters, TheViewOfTheWindowHasItsUpwardDirection) {
    DrawingParameters chosen;
    chosen.views = "window";
    const line_drawing::ViewFrame view = sheetOptions(chosen, window).views.at(0);
    EXPECT_EQ(view.towards_viewer, Eigen::Vector3d(1, 0, 0));
    EXPECT_EQ(view.up, Eigen::Vector3d(0, 0, 1));
    EXPECT_EQ(view.right, Eigen::Vector3d(0, 1, 0));
    EXPECT_FALSE(view.eye);
    CurrentView perspective = window;
    perspective.is_orthographic = false;
    EXPECT_EQ(sheetOptions(chosen, perspective).views.at(0).eye, window.eye);
    EXPECT_THROW(sheetOptions(chosen, std::nullopt), Error);
    chosen.views = "front";
    EXPECT_EQ(sheetOptions(chosen, std::nullopt).views.size(), 1u);
}

TEST(DrawingParameters, BecomeOptionsOfASheet) {
    DrawingParameters chosen;
    chosen.file = "plate.DXF";
    chosen.scale = "1:4";
    chosen.paper = 6;
    chosen.unit = 3;
    chosen.look.up = line_drawing::UpAxis::Z;
    chosen.title = "Find 17";
    chosen.look.wall = line_drawing::WallStyle::Filled;
    chosen.look.hidden = line_drawing::HiddenLines::Dashed;
    chosen.look.has_furniture = false;
    const SheetOptions options = sheetOptions(chosen, std::nullopt);
    EXPECT_EQ(options.scale, 0.25);
    EXPECT_EQ(options.paper, "fit");
    EXPECT_EQ(options.mm_per_unit, 25.4);
    EXPECT_EQ(options.views.at(0).up, Eigen::Vector3d(0, 0, 1));
    EXPECT_EQ(options.strokes, line_drawing::StrokeStyle::Plain);
    EXPECT_EQ(options.title, "Find 17");
    EXPECT_EQ(options.hidden, line_drawing::HiddenLines::Dashed);
    EXPECT_EQ(options.wall, line_drawing::WallStyle::Filled);
    EXPECT_FALSE(options.has_furniture);
    chosen.scale = "half";
    EXPECT_THROW(sheetOptions(chosen, std::nullopt), Error);
}

TEST(DrawingParameters, AreReadAsTheyWereListed) {
    DrawingParameters given;
    given.file = "a.pdf";
    given.views = "six";
    given.scale = "2:1";
    given.sections = "y=0.4";
    given.title = "A = B";
    given.paper = 0;
    given.unit = 2;
    given.look.up = line_drawing::UpAxis::X;
    given.look.arrangement = line_drawing::Arrangement::ThirdAngle;
    given.look.wall = line_drawing::WallStyle::None;
    given.look.has_furniture = false;
    given.settings = line_drawing::settings_of_decoration;
    given.is_of_all_layers = true;
    given.look.hidden = line_drawing::HiddenLines::Dashed;
    RichParameterList list;
    listDrawingParameters(given, list);
    const DrawingParameters read = readDrawingParameters(list);
    EXPECT_EQ(
        (line_drawing::Words{read.file, read.views, read.scale, read.sections, read.title}),
        (line_drawing::Words{given.file, given.views, given.scale, given.sections, given.title}));
    EXPECT_EQ(read.paper, 0);
    EXPECT_EQ(read.unit, 2);
    EXPECT_EQ(read.look.up, given.look.up);
    EXPECT_EQ(read.look.arrangement, given.look.arrangement);
    EXPECT_EQ(read.look.wall, given.look.wall);
    EXPECT_FALSE(read.look.has_furniture);
    EXPECT_EQ(read.settings, line_drawing::settings_of_decoration);
    EXPECT_TRUE(read.is_of_all_layers);
    EXPECT_EQ(read.look.hidden, given.look.hidden);
    given.paper = 7;
    RichParameterList wrong;
    listDrawingParameters(given, wrong);
    EXPECT_THROW(readDrawingParameters(wrong), Error);
}

TEST(DrawingParameters, StartBesideTheMeshAndAtTheWindow) {
    EXPECT_EQ(drawingDefaults(nullptr, false).file, "drawing.svg");
    EXPECT_EQ(drawingDefaults(nullptr, false).views, "front");
    EXPECT_EQ(drawingDefaults(nullptr, true).views, "window");
    MeshDocument document;
    MeshModel* mesh = document.addNewMesh("/finds/find.17.ply", "find");
    EXPECT_EQ(drawingDefaults(mesh, false).file, "/finds/find.17_drawing.svg");
    // Scripts have one unit, whatever the size.
    mesh->cm.bbox.Set(Point3m(0, 0, 0));
    mesh->cm.bbox.Add(Point3m(1, 1, 1));
    EXPECT_EQ(drawingDefaults(mesh, false).unit, 0);
    EXPECT_EQ(drawingDefaults(mesh, true).unit, 2);
    mesh->cm.Tr.SetScale(1000, 1000, 1000);
    EXPECT_EQ(drawingDefaults(mesh, true).unit, 0);
}

TEST(DrawingParameters, AreRecordedForAnyMesh) {
    MeshDocument document;
    const MeshModel& mesh = *document.addNewMesh("/finds/find.17.ply", "find");
    const MeshModel& next = *document.addNewMesh("/more/18.ply", "next");
    DrawingParameters chosen = drawingDefaults(&mesh, true);
    chosen.views = "front, window";
    const DrawingParameters recorded = forAnyMesh(chosen, mesh, window);
    EXPECT_EQ(recorded.views, "front toward 1 0 0 0 0 1");
    EXPECT_EQ(fileFor(mesh, recorded.file), chosen.file);
    EXPECT_EQ(fileFor(next, recorded.file), "/more/18_drawing.svg");
    EXPECT_EQ(sheetOptions(recorded, std::nullopt).views.at(1).right, Eigen::Vector3d(0, 1, 0));
    chosen.file = "/elsewhere/find.17.svg";
    EXPECT_EQ(forAnyMesh(chosen, mesh, window).file, chosen.file);
}

TEST(DrawingParameters, TakeLinesAndLightFromTheDecoration) {
    int count = 0;
    QCoreApplication application(count, nullptr);
    DrawingParameters chosen;
    chosen.settings = line_drawing::settings_of_decoration;
    EXPECT_THROW(sheetOptions(chosen, std::nullopt), Error);
    meshlab_host::DrawnStyle drawn;
    drawn.style.detail = 77;
    drawn.light_azimuth = 90;  // from the right of the picture
    meshlab_host::noteDrawnStyle(drawn);
    const SheetOptions options = sheetOptions(chosen, std::nullopt);
    EXPECT_EQ(options.style.detail, 77);
    ASSERT_TRUE(options.light);
    EXPECT_TRUE(options.light->isApprox(Eigen::Vector3d(1, 0, 1).normalized(), 1e-12));
    drawn.light_azimuth.reset();
    meshlab_host::noteDrawnStyle(drawn);
    EXPECT_FALSE(sheetOptions(chosen, std::nullopt).light);
}

TEST(DrawingParameters, TakeTheKindsOfMixtures) {
    for (std::size_t i = 0; i < laplacian_lines::line_mixtures.size(); ++i) {
        DrawingParameters chosen;
        chosen.settings = line_drawing::settings_of_decoration + 1 + int(i);
        const SheetOptions options = sheetOptions(chosen, std::nullopt);
        for (const auto& kind : laplacian_lines::line_kinds)
            EXPECT_EQ(options.style.shows[kind.kind],
                      laplacian_lines::line_mixtures[i].kinds[kind.kind])
                << laplacian_lines::line_mixtures[i].key << ": " << kind.key;
    }
}

TEST(DrawingUnits, AreThoseThatScansUsuallyHave) {
    const auto unit = [](double diagonal) {
        return std::string(line_drawing::mesh_units[likelyUnit(diagonal)].name);
    };
    EXPECT_EQ(unit(0.05), "m");  // a coin of photogrammetry
    EXPECT_EQ(unit(6), "m");     // a trench
    EXPECT_EQ(unit(15), "mm");   // a bead of a scanner
    EXPECT_EQ(unit(1800), "mm");
}

}  // namespace
