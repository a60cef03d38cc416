// SPDX-License-Identifier: GPL-3.0-or-later
// From where the polyline filter looks, what it says of eyes that do not see all, and what it takes
// over from the decoration.
#include <gtest/gtest.h>

#include <QCoreApplication>

#include "laplacian_lines/error.h"
#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/option_table.h"
#include "line_drawing/sheet_choices.h"
#include "meshlab_host/drawn_style.h"
#include "polyline_view.h"

namespace {

using line_drawing::ViewFrame;
using meshlab_host::CurrentView;

const Eigen::AlignedBox3d kBox(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));

ViewFrame frame_at(const Eigen::Vector3d& viewpoint) {
    PolylineParameters chosen;
    chosen.view = ViewChoice::Perspective;
    chosen.viewpoint = viewpoint;
    return frame_of(chosen, kBox.center(), std::nullopt);
}

TEST(PolylineView, SidesHaveAnUprightPicture) {
    for (int choice = int(ViewChoice::Front); choice <= int(ViewChoice::Bottom); ++choice) {
        PolylineParameters chosen;
        chosen.view = ViewChoice(choice);
        const ViewFrame frame = frame_of(chosen, {5, 6, 7}, std::nullopt);
        EXPECT_FALSE(frame.eye);
        EXPECT_EQ(frame.towards_viewer.norm(), 1);
        EXPECT_NEAR(frame.up.norm(), 1, 1e-15);
        EXPECT_NEAR(frame.up.dot(frame.towards_viewer), 0, 1e-15);
        EXPECT_TRUE(nearness_warning(frame, kBox).isEmpty());
        const bool is_upright = frame.towards_viewer.y() == 0;
        EXPECT_EQ(frame.up.y(), is_upright ? 1 : 0);
        EXPECT_TRUE(view_text(frame, chosen).contains(QString::fromStdString(frame.name)));
    }
}

TEST(PolylineView, DefaultsSeeAllFromOutside) {
    const PolylineParameters defaults = polyline_defaults(nullptr, std::nullopt);
    EXPECT_EQ(defaults.view, ViewChoice::Front);
    MeshDocument document;
    MeshModel* mesh = document.addNewMesh("", "box");
    mesh->cm.bbox = Box3m(Point3m(10, 20, 30), Point3m(11, 22, 33));
    const Eigen::AlignedBox3d far_box(Eigen::Vector3d(10, 20, 30), Eigen::Vector3d(11, 22, 33));
    PolylineParameters chosen = polyline_defaults(mesh, std::nullopt);
    EXPECT_EQ(chosen.view, ViewChoice::Front);
    chosen.view = ViewChoice::Perspective;
    const ViewFrame frame = frame_of(chosen, far_box.center(), std::nullopt);
    EXPECT_TRUE(nearness_warning(frame, far_box).isEmpty());
    EXPECT_GT(chosen.viewpoint.z(), 33);
    mesh->cm.Tr.SetScale(100, 100, 100);
    const Eigen::AlignedBox3d larger(100 * far_box.min(), 100 * far_box.max());
    chosen.viewpoint = polyline_defaults(mesh, std::nullopt).viewpoint;
    EXPECT_TRUE(nearness_warning(frame_of(chosen, larger.center(), {}), larger).isEmpty());
}

TEST(PolylineView, WarnsOfEyesWithinTheBoxOrCloseToIt) {
    EXPECT_TRUE(nearness_warning(frame_at({0, 0, 4}), kBox).isEmpty());
    EXPECT_TRUE(
        nearness_warning(frame_at({0.5, 0.2, 0}), kBox).contains("within the bounding box"));
    EXPECT_TRUE(nearness_warning(frame_at({0, 0, 0}), kBox).contains("within the bounding box"));
    EXPECT_TRUE(nearness_warning(frame_at({0, 0, 1.2}), kBox).contains("sees only part"));
    EXPECT_TRUE(nearness_warning(frame_at({0, 0, 0}), Eigen::AlignedBox3d()).isEmpty());
    EXPECT_TRUE(nearness_warning(frame_at({0.12345678, 0, 0}), kBox).contains(" 0.12345678 0 0 "));
}

TEST(PolylineView, ThatOfTheWindowHasItsUpwardDirection) {
    PolylineParameters chosen;
    chosen.view = ViewChoice::CurrentView;
    EXPECT_THROW(frame_of(chosen, kBox.center(), std::nullopt), laplacian_lines::Error);
    const CurrentView window{false, {0, 0, 9}, {0, 0, 1}, {1, 0, 0}};
    const ViewFrame frame = frame_of(chosen, kBox.center(), window);
    EXPECT_EQ(frame.eye, window.eye);
    EXPECT_EQ(frame.up, window.up);
}

TEST(PolylineView, CameraLightTurnsWithThePicture) {
    PolylineParameters chosen;
    chosen.view = ViewChoice::Left;
    chosen.light_azimuth = 90;  // from the right of the picture
    const ViewFrame frame = frame_of(chosen, kBox.center(), std::nullopt);
    const auto view = view_of(frame, chosen, Eigen::Matrix4d::Identity());
    ASSERT_TRUE(view.light);
    EXPECT_TRUE(view.light->normalized().isApprox(Eigen::Vector3d(-1, 0, 1).normalized(), 1e-12))
        << "the viewer is at -x";
    EXPECT_THROW(view_of(frame, chosen, Eigen::Matrix4d::Zero()), laplacian_lines::Error);
}

/// A style whose every number differs from its default.
laplacian_lines::LineStyle other_style() {
    laplacian_lines::LineStyle style;
    for (const auto& row : laplacian_lines::line_style_table()) {
        const double value = row.get(style);
        row.set(style, value == row.maximum ? row.minimum : std::min(value + 1, row.maximum));
    }
    return style;
}

TEST(DrawnStyle, IsReadAsItWasNoted) {
    int count = 0;
    QCoreApplication application(count, nullptr);
    RichParameterList list;
    PolylineParameters asked;
    asked.settings = line_drawing::kSettingsOfDecoration;
    list_polyline_parameters(asked, list);
    EXPECT_THROW(read_polyline_parameters(list), laplacian_lines::Error);

    meshlab_host::DrawnStyle drawn;
    drawn.style = other_style();
    drawn.light_azimuth = 12;
    drawn.shows_hidden = true;
    drawn.colors.fill(0xff123456);
    meshlab_host::note_drawn_style(drawn);
    const PolylineParameters read = read_polyline_parameters(list);
    for (const auto& row : laplacian_lines::line_style_table())
        EXPECT_EQ(row.get(read.style), row.get(drawn.style)) << row.key;
    EXPECT_FALSE(read.visible_only);
    EXPECT_EQ(read.colors, drawn.colors);
    EXPECT_EQ(read.light_azimuth, 12);

    drawn.light_azimuth.reset();
    meshlab_host::note_drawn_style(drawn);
    EXPECT_FALSE(read_polyline_parameters(list).light_azimuth);
}

TEST(PolylineSettings, OfMixturesAreTheirKindsAndColors) {
    for (std::size_t i = 0; i < laplacian_lines::kLineMixtures.size(); ++i) {
        const laplacian_lines::LineMixture& mixture = laplacian_lines::kLineMixtures[i];
        PolylineParameters asked;
        asked.settings = line_drawing::kSettingsOfDecoration + 1 + int(i);
        asked.style.detail = 70;
        RichParameterList list;
        list_polyline_parameters(asked, list);
        const PolylineParameters read = read_polyline_parameters(list);
        EXPECT_EQ(read.style.detail, 70);
        for (const auto& kind : laplacian_lines::kLineKinds) {
            EXPECT_EQ(read.style.shows[kind.kind], mixture.kinds[kind.kind])
                << mixture.key << ": " << kind.key;
            EXPECT_EQ(read.colors[std::size_t(kind.kind)] & 0xffffff,
                      mixture.colored[kind.kind] ? kind.key_color : 0)
                << mixture.key << ": " << kind.key;
        }
    }
}

}  // namespace
