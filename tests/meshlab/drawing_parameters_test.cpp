// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>

#include "drawing_parameters.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/line_mixture.h"
#include "meshlab_host/drawn_style.h"

namespace {

using laplacian_lines::Error;
using line_drawing::SheetOptions;
using meshlab_host::CurrentView;

const CurrentView kWindow{true, {0, 0, 9}, {1, 0, 0}, {0, 0, 1}};  // seen from x, z up

TEST(DrawingParameters, TheViewOfTheWindowHasItsUpwardDirection) {
    DrawingParameters chosen;
    chosen.views = "window";
    const line_drawing::ViewFrame view = sheet_options(chosen, kWindow).views.at(0);
    EXPECT_EQ(view.towards_viewer, Eigen::Vector3d(1, 0, 0));
    EXPECT_EQ(view.up, Eigen::Vector3d(0, 0, 1));
    EXPECT_EQ(view.right, Eigen::Vector3d(0, 1, 0));
    EXPECT_FALSE(view.eye);
    CurrentView perspective = kWindow;
    perspective.is_orthographic = false;
    EXPECT_EQ(sheet_options(chosen, perspective).views.at(0).eye, kWindow.eye);
    EXPECT_THROW(sheet_options(chosen, std::nullopt), Error);
    chosen.views = "front";
    EXPECT_EQ(sheet_options(chosen, std::nullopt).views.size(), 1u);
}

TEST(DrawingParameters, AreReadAsTheyWereListed) {
    DrawingParameters given;
    for (const auto& option : line_drawing::sheet_option_table())
        if (option.row.text)
            given.*option.row.text = option.row.key;
        else if (option.row.get(given) < option.row.maximum)
            option.row.set(given, option.row.maximum);
        else
            option.row.set(given, option.row.minimum);
    RichParameterList list;
    list_drawing_parameters(given, list);
    const DrawingParameters read = read_drawing_parameters(list);
    for (const auto& option : line_drawing::sheet_option_table()) {
        if (!option.is_of(line_drawing::SheetOption::Place::Filter)) continue;
        if (option.row.text) {
            EXPECT_EQ(read.*option.row.text, option.row.key);
        } else {
            EXPECT_EQ(option.row.get(read), option.row.get(given)) << option.row.key;
        }
    }
    given.paper = 7;
    RichParameterList wrong;
    list_drawing_parameters(given, wrong);
    EXPECT_THROW(read_drawing_parameters(wrong), Error);
}

TEST(DrawingParameters, StartBesideTheMeshAndAtTheWindow) {
    EXPECT_EQ(drawing_defaults(nullptr, false).file, "drawing.svg");
    EXPECT_EQ(drawing_defaults(nullptr, false).views, "front");
    EXPECT_EQ(drawing_defaults(nullptr, true).views, "window");
    MeshDocument document;
    MeshModel* mesh = document.addNewMesh("/finds/find.17.ply", "find");
    EXPECT_EQ(drawing_defaults(mesh, false).file, "/finds/find.17_drawing.svg");
    // Scripts have one unit, whatever the size.
    mesh->cm.bbox.Set(Point3m(0, 0, 0));
    mesh->cm.bbox.Add(Point3m(1, 1, 1));
    EXPECT_EQ(drawing_defaults(mesh, false).unit, 0);
    EXPECT_EQ(drawing_defaults(mesh, true).unit, 2);
    mesh->cm.Tr.SetScale(1000, 1000, 1000);
    EXPECT_EQ(drawing_defaults(mesh, true).unit, 0);
}

TEST(DrawingParameters, AreRecordedForAnyMesh) {
    MeshDocument document;
    const MeshModel& mesh = *document.addNewMesh("/finds/find.17.ply", "find");
    const MeshModel& next = *document.addNewMesh("/more/18.ply", "next");
    DrawingParameters chosen = drawing_defaults(&mesh, true);
    chosen.views = "front, window";
    const DrawingParameters recorded = for_any_mesh(chosen, mesh, kWindow);
    EXPECT_EQ(recorded.views, "front toward 1 0 0 0 0 1");
    EXPECT_EQ(file_for(mesh, recorded.file), chosen.file);
    EXPECT_EQ(file_for(next, recorded.file), "/more/18_drawing.svg");
    const MeshModel& made = *document.addNewMesh("", "box");
    EXPECT_EQ(file_for(made, recorded.file),
              (QDir::currentPath() + "/box_drawing.svg").toStdString());
    EXPECT_EQ(sheet_options(recorded, std::nullopt).views.at(1).right, Eigen::Vector3d(0, 1, 0));
    chosen.file = "/elsewhere/find.17.svg";
    EXPECT_EQ(for_any_mesh(chosen, mesh, kWindow).file, chosen.file);
}

TEST(DrawingParameters, TakeLinesAndLightFromTheDecoration) {
    int count = 0;
    QCoreApplication application(count, nullptr);
    DrawingParameters chosen;
    chosen.settings = line_drawing::kSettingsOfDecoration;
    EXPECT_THROW(sheet_options(chosen, std::nullopt), Error);
    meshlab_host::DrawnStyle drawn;
    drawn.style.detail = 77;
    drawn.light_azimuth = 90;  // from the right of the picture
    meshlab_host::note_drawn_style(drawn);
    const SheetOptions options = sheet_options(chosen, std::nullopt);
    EXPECT_EQ(options.style.detail, 77);
    ASSERT_TRUE(options.light);
    EXPECT_TRUE(options.light->isApprox(Eigen::Vector3d(1, 0, 1).normalized(), 1e-12));
    drawn.light_azimuth.reset();
    meshlab_host::note_drawn_style(drawn);
    EXPECT_FALSE(sheet_options(chosen, std::nullopt).light);
}

TEST(DrawingParameters, TakeTheKindsOfMixtures) {
    for (std::size_t i = 0; i < laplacian_lines::kLineMixtures.size(); ++i) {
        DrawingParameters chosen;
        chosen.settings = line_drawing::kSettingsOfDecoration + 1 + int(i);
        const SheetOptions options = sheet_options(chosen, std::nullopt);
        for (const auto& kind : laplacian_lines::kLineKinds)
            EXPECT_EQ(options.style.shows[kind.kind],
                      laplacian_lines::kLineMixtures[i].kinds[kind.kind])
                << laplacian_lines::kLineMixtures[i].key << ": " << kind.key;
    }
}

TEST(DrawingUnits, AreThoseThatScansUsuallyHave) {
    const auto unit = [](double diagonal) {
        return std::string(line_drawing::kMeshUnits[line_drawing::likely_unit(diagonal)].name);
    };
    EXPECT_EQ(unit(0.05), "m");  // a coin of photogrammetry
    EXPECT_EQ(unit(6), "m");     // a trench
    EXPECT_EQ(unit(15), "mm");   // a bead of a scanner
    EXPECT_EQ(unit(1800), "mm");
}

}  // namespace
