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

TEST(DrawingParameters, AreReadAsTheyWereListed) {
    DrawingParameters given;
    for (const auto& option : line_drawing::sheetOptionTable())
        if (option.row.text)
            given.*option.row.text = option.row.key;
        else if (option.row.get(given) < option.row.maximum)
            option.row.set(given, option.row.maximum);
        else
            option.row.set(given, option.row.minimum);
    RichParameterList list;
    listDrawingParameters(given, list);
    const DrawingParameters read = readDrawingParameters(list);
    for (const auto& option : line_drawing::sheetOptionTable()) {
        if (!option.isOf(line_drawing::SheetOption::Place::Filter)) continue;
        if (option.row.text) {
            EXPECT_EQ(read.*option.row.text, option.row.key);
        } else {
            EXPECT_EQ(option.row.get(read), option.row.get(given)) << option.row.key;
        }
    }
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
