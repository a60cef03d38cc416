// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the renderers without OpenGL: looks, surfaces, the clock, scales.
#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "line_renderer/line_appearance.h"
#include "line_renderer/redraw_clock.h"
#include "line_renderer/surface.h"
#include "line_stream.h"

namespace {

using laplacian_lines::Field;
using laplacian_lines::TriangleMesh;
using line_renderer::RedrawClock;
using line_renderer::SurfaceLayer;

TEST(UsualLooks, AreThoseOfTheTable) {
    const line_renderer::LineLooks looks = line_renderer::usualLooks();
    ASSERT_EQ(looks.size(), laplacian_lines::line_kinds.size());
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const auto& kind = laplacian_lines::line_kinds[i];
        EXPECT_EQ(looks[i].color.rgba(), 0xff000000 | kind.color) << kind.key;
        EXPECT_DOUBLE_EQ(looks[i].width, line_renderer::usual_line_width * kind.width) << kind.key;
    }
}

TEST(Surface, HasTheTrianglesWhoseCornersAreFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}, {1e300, 0, 0}};
    mesh.triangles = {{0, 1, 3}, {0, 1, 2}, {4, 1, 2}, {0, 1, 9}};
    Field field;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        field.normals.push_back({0, 0, float(i)});
    const line_renderer::SurfacePointer surface = line_renderer::makeSurface(mesh, field);
    ASSERT_EQ(surface->vertices.size(), mesh.positions.size());
    EXPECT_EQ(surface->vertices[2].position, Eigen::Vector3f(0, 1, 0));
    EXPECT_EQ(surface->vertices[2].normal, Eigen::Vector3f(0, 0, 2));
    ASSERT_EQ(surface->triangles.size(), 1u);
    EXPECT_EQ(surface->triangles[0], (laplacian_lines::Triangle{0, 1, 2}));
}

TEST(SurfaceLayer, IsTheSameOnlyIfItLooksTheSame) {
    const auto surface = std::make_shared<line_renderer::Surface>();
    const auto other = std::make_shared<line_renderer::Surface>();
    SurfaceLayer layer;
    layer.surface = surface;
    SurfaceLayer changed = layer;
    EXPECT_EQ(changed, layer);
    changed.surface = other;
    EXPECT_NE(changed, layer);
    changed = layer;
    changed.transform(0, 3) = 1;
    EXPECT_NE(changed, layer);
    changed = layer;
    changed.culls_back_faces = true;
    EXPECT_NE(changed, layer);
    changed = layer;
    changed.is_in_depth_buffer = true;
    EXPECT_NE(changed, layer);
}

TEST(RedrawClock, CountsEachPartOnItsOwn) {
    using namespace std::chrono_literals;
    const auto begin = std::chrono::steady_clock::now();
    RedrawClock clock;
    std::this_thread::sleep_for(3ms);
    clock.count(RedrawClock::Extraction);
    std::this_thread::sleep_for(5ms);
    clock.count(RedrawClock::Drawing);
    std::this_thread::sleep_for(3ms);
    clock.count(RedrawClock::Extraction);
    clock.count(RedrawClock::Upload);
    const std::chrono::duration<double, std::milli> all = std::chrono::steady_clock::now() - begin;
    EXPECT_GE(clock.milliseconds(RedrawClock::Extraction), 6);
    EXPECT_GE(clock.milliseconds(RedrawClock::Drawing), 5);
    EXPECT_EQ(clock.milliseconds(RedrawClock::DrawCalls), 0);
    EXPECT_DOUBLE_EQ(clock.ownMilliseconds(), clock.milliseconds(RedrawClock::Extraction) +
                                                  clock.milliseconds(RedrawClock::Upload));
    EXPECT_LE(clock.ownMilliseconds() + clock.milliseconds(RedrawClock::Drawing), all.count());
}

TEST(MeanScale, IsThatOfAVolume) {
    Eigen::Matrix4d transform = Eigen::Vector4d(2, -4, 8, 1).asDiagonal();
    transform.col(3).head<3>() << 5, 6, 7;
    EXPECT_DOUBLE_EQ(line_renderer::meanScale(transform), 4);
}

}  // namespace
