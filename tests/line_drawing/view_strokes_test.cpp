// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes of a view in space are those of its drawing.
#include "line_drawing/view_strokes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "laplacian_lines/error.h"
#include "laplacian_lines/line_extractor.h"
#include "sheet_helpers.h"

using namespace line_drawing;
using Eigen::Vector3d;
using laplacian_lines::TriangleMesh;
using laplacian_lines::ViewLine;
using laplacian_lines::ViewLinePoint;

namespace {

/// Of the radii .9 to 1.1.
TriangleMesh bumps() {
    return test_meshes::bumpy_sphere(6, 0.15).mesh;
}

ViewFrame frame_at(const Vector3d& towards_viewer, bool has_eye) {
    ViewFrame frame;
    frame.side = Side::Other;
    frame.towards_viewer = towards_viewer.normalized();
    frame.up = frame.towards_viewer.unitOrthogonal();
    frame.right = frame.up.cross(frame.towards_viewer);
    if (has_eye) frame.eye = 6 * frame.towards_viewer;
    return frame;
}

double length_of(const std::vector<ViewLine>& lines) {
    double length = 0;
    for (const ViewLine& line : lines)
        for (std::size_t i = 1; i < line.points.size(); ++i)
            length += (line.points[i].position - line.points[i - 1].position).norm();
    return length;
}

TEST(ViewStrokes, LieOnTheSurface) {
    const TriangleMesh mesh = bumps();
    for (const bool has_eye : {false, true}) {
        const ViewFrame frame = frame_at({1, 2, 3}, has_eye);
        const std::vector<ViewLine> strokes = strokes_of({{mesh}}, frame, {});
        ASSERT_GE(strokes.size(), 2u);
        EXPECT_TRUE(std::any_of(strokes.begin(), strokes.end(),
                                [](const ViewLine& line) { return line.is_outline; }));
        for (const ViewLine& line : strokes)
            for (const ViewLinePoint& point : line.points) {
                EXPECT_GT(point.position.norm(), 0.83);
                EXPECT_LT(point.position.norm(), 1.17);
                EXPECT_LE(point.weight, 1.001f);
            }
    }
}

TEST(ViewStrokes, AreFewerAndLongerThanWhatIsSeen) {
    const TriangleMesh mesh = bumps();
    const ViewFrame frame = frame_at({1, 2, 3}, false);
    const laplacian_lines::LineVisibility visibility(mesh);
    const laplacian_lines::LineExtractor extractor(mesh, laplacian_lines::precompute(mesh));
    const auto view = laplacian_lines::View::orthographic(frame.towards_viewer);
    laplacian_lines::ExtractionScratch scratch;
    const std::vector<ViewLine> seen =
        visibility.visible_lines(view, {extract_on_surface(extractor, view, {}, scratch)}, {});
    const std::vector<ViewLine> strokes = strokes_of({{mesh}}, frame, {});
    EXPECT_LT(2 * strokes.size(), seen.size());
    EXPECT_GT(length_of(strokes) / double(strokes.size()),
              2 * length_of(seen) / double(seen.size()));
}

/// A ball before a plate that is far away: the plate's border goes on behind the ball.
TEST(ViewStrokes, EndWhereTheirLineGoesOnBehindAnother) {
    const TriangleMesh ball = bumps(),
                       plate = test_meshes::moved(test_meshes::plane(8), {1, 0, -10});
    const Objects objects = {{ball}, {plate}};
    const auto strokes = strokes_of(objects, frame_at({0, 0, 1}, false), {});
    int near = 0, far = 0;
    for (const ViewLine& line : strokes) {
        const auto [low, high] =
            std::minmax_element(line.points.begin(), line.points.end(),
                                [](auto& a, auto& b) { return a.position.z() < b.position.z(); });
        EXPECT_LT(high->position.z() - low->position.z(), 2.5);
        ++(low->position.z() < -5 ? far : near);
    }
    EXPECT_GE(far, 1);
    EXPECT_GE(near, 5);
}

TEST(ViewStrokes, FollowTheDetail) {
    const TriangleMesh mesh = bumps();
    const auto length_at = [&](double detail) {
        SheetOptions options;
        options.style.detail = detail;
        return length_of(strokes_of({{mesh}}, frame_at({1, 2, 3}, false), options));
    };
    EXPECT_LT(length_at(0), length_at(100));
}

TEST(ViewStrokes, RefuseAnEyeInside) {
    const TriangleMesh mesh = bumps();
    ViewFrame frame = frame_at({0, 0, 1}, true);
    frame.eye = Vector3d(0, 0, 0.1);
    EXPECT_THROW(strokes_of({{mesh}}, frame, {}), laplacian_lines::Error);
}

}  // namespace
