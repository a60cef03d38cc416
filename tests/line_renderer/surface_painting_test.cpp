// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces as paper and in flat tones, and the background.
#include <cmath>
#include <map>

#include "gl_test.h"
#include "line_renderer/surface_depth.h"
#include "line_renderer/surface_renderer.h"

namespace {

using Eigen::Vector3f;
using line_renderer::DepthTexture;
using line_renderer::SurfacePointer;
using line_renderer::SurfaceStyle;

const QColor paper = Qt::white, shade(150, 150, 150), nothing = Qt::blue;

/// Unit, at this cosine to the ray.
Vector3f normalAt(float cosine) {
    return {std::sqrt(1 - cosine * cosine), 0, cosine};
}

class SurfacePaintingTest : public GlTest {
protected:
    SurfacePaintingTest() { canvas_.clear(1, nothing); }

    QImage painted(const Rectangles& rectangles, SurfaceStyle style = SurfaceStyle::Paper,
                   const DepthTexture& depth = {0, {0, 0}, true}) {
        surface_ = rectangles.surface();
        renderer_.paint(layerOf(surface_), style, Eigen::Matrix4d::Identity(), depth, buffers_);
        return canvas_.picture();
    }

    SurfacePointer surface_;
    line_renderer::SurfaceBuffers buffers_;
    line_renderer::SurfaceRenderer renderer_;
};

TEST_F(SurfacePaintingTest, PaperIsWhiteAndNowhereElseAndHasNoDepth) {
    Rectangles rectangles;
    rectangles.add(10, 10, 50, 40, 0, normalAt(0.1f));
    rectangles.add(80, 20, 30, 70, 0.2, normalAt(1));
    const QImage picture = painted(rectangles);
    for (int x = 0; x < Canvas::width; ++x)
        for (int y = 0; y < Canvas::height; ++y) {
            const bool is_left = x >= 10 && x < 60 && y >= 10 && y < 50;
            const bool is_right = x >= 80 && x < 110 && y >= 20 && y < 90;
            ASSERT_EQ(colorAt(picture, x, y), is_left || is_right ? paper : nothing)
                << x << ", " << y;
        }
    GLfloat depth = 0;
    glReadPixels(90, 60, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    EXPECT_EQ(depth, 1);
}

/// Three, with hardly a pixel in between.
TEST_F(SurfacePaintingTest, TonesFollowTheAngleToTheEye) {
    for (const float side : {1.f, -1.f}) {
        Rectangles rectangles;
        for (int x = 0; x < Canvas::width; ++x)
            rectangles.add(x, 0, 1, Canvas::height, 0, normalAt(side * (float(x) + 0.5f) / 160));
        const QImage picture = painted(rectangles, SurfaceStyle::Toon);
        std::map<int, int> columns;
        for (int x = 0; x < Canvas::width; ++x)
            ++columns[colorAt(picture, x, 60).green()];
        for (const auto& [tone, count] : columns)
            EXPECT_EQ(count > 3, tone == 150 || tone == 255 || std::abs(tone - 202) < 2) << tone;
        EXPECT_EQ(colorAt(picture, 0, 60), shade);
        EXPECT_EQ(colorAt(picture, Canvas::width - 1, 60), paper);
    }
}

/// But wires and points that stand out slightly are covered.
TEST_F(SurfacePaintingTest, LeavesWhatIsNearer) {
    canvas_.putDepth(0, 0, 50, Canvas::height, 0.5);
    canvas_.putDepth(50, 0, 50, Canvas::height, 0.0004);
    canvas_.putDepth(100, 0, 60, Canvas::height, 0.0016);
    Rectangles rectangles;
    rectangles.add(0, 0, 160, 120, 0);
    const QImage picture = painted(rectangles);
    EXPECT_EQ(colorAt(picture, 25, 60), nothing);
    EXPECT_EQ(colorAt(picture, 75, 60), paper);
    EXPECT_EQ(colorAt(picture, 125, 60), nothing);
}

/// In any order.
TEST_F(SurfacePaintingTest, PaintsTheNearestFacesOfTheTexture) {
    Rectangles rectangles;
    rectangles.add(0, 0, 160, 120, 0.4, normalAt(0.95f));
    rectangles.add(40, 0, 80, 120, -0.4, normalAt(0.05f));
    surface_ = rectangles.surface();
    line_renderer::SurfaceDepth depth;
    const DepthTexture texture = depth.update({layerOf(surface_)}, buffers_);
    const QImage picture = painted(rectangles, SurfaceStyle::Toon, texture);
    EXPECT_EQ(colorAt(picture, 20, 60), paper);
    EXPECT_EQ(colorAt(picture, 80, 60), paper);
}

/// Snapshots without background stay so.
TEST_F(SurfacePaintingTest, BackgroundIsWhereNothingIsAndLeavesAlphaAndDepth) {
    canvas_.clear(0, nothing);
    canvas_.putDepth(30, 20, 50, 40, 0.5);
    canvas_.putDepth(100, 20, 20, 40, -0.999);
    renderer_.paintBackground();
    const QImage picture = canvas_.picture();
    for (int x = 0; x < Canvas::width; ++x)
        for (int y = 0; y < Canvas::height; ++y) {
            const bool is_left = x >= 30 && x < 80 && y >= 20 && y < 60;
            const bool is_right = x >= 100 && x < 120 && y >= 20 && y < 60;
            const QColor color = colorAt(picture, x, y);
            ASSERT_EQ(color.rgb(), is_left || is_right ? nothing.rgb() : paper.rgb())
                << x << ", " << y;
            ASSERT_EQ(color.alpha(), 0);
        }
    GLfloat depth = 0;
    glReadPixels(80, 60, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    EXPECT_EQ(depth, 1);
}

}  // namespace
