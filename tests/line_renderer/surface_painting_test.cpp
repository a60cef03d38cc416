// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces as paper and in flat tones, and the background.
#include <algorithm>
#include <cmath>
#include <map>

#include "gl_context.h"
#include "line_renderer/background_renderer.h"
#include "line_renderer/surface_depth.h"
#include "line_renderer/surface_renderer.h"

namespace {

using Eigen::Vector3f;
using line_renderer::DepthTexture;
using line_renderer::SurfaceAppearance;
using line_renderer::SurfacePointer;

const QColor paper(250, 240, 210), shade(90, 100, 110);

/// Unit, at this cosine to the ray.
Vector3f normalAt(float cosine) {
    return {std::sqrt(1 - cosine * cosine), 0, cosine};
}

class SurfacePaintingTest : public GlTest {
protected:
    static SurfaceAppearance appearanceOf(SurfaceAppearance::Style style, int tones = 3) {
        SurfaceAppearance result;
        result.style = style;
        result.paper = paper;
        result.shade = shade;
        result.tones = tones;
        return result;
    }

    QImage painted(const Rectangles& rectangles, const SurfaceAppearance& appearance,
                   const DepthTexture& depth = {0, {0, 0}, true}) {
        surface_ = rectangles.surface();
        renderer_.paint(layerOf(surface_), appearance, Eigen::Matrix4d::Identity(), depth,
                        buffers_);
        return canvas_.picture();
    }

    SurfacePointer surface_;
    line_renderer::SurfaceBuffers buffers_;
    line_renderer::SurfaceRenderer renderer_;
};

TEST_F(SurfacePaintingTest, PaperIsOfOneColorAndNowhereElse) {
    Rectangles rectangles;
    rectangles.add(10, 10, 50, 40, 0, normalAt(0.1f));
    rectangles.add(80, 20, 30, 70, 0.2, normalAt(1));
    const QImage picture = painted(rectangles, appearanceOf(SurfaceAppearance::Paper));
    for (int x = 0; x < Canvas::width; ++x)
        for (int y = 0; y < Canvas::height; ++y) {
            const bool is_left = x >= 10 && x < 60 && y >= 10 && y < 50;
            const bool is_right = x >= 80 && x < 110 && y >= 20 && y < 90;
            ASSERT_EQ(colorAt(picture, x, y), is_left || is_right ? paper : QColor(Qt::white))
                << x << ", " << y;
        }
}

TEST_F(SurfacePaintingTest, TonesFollowTheAngleToTheEye) {
    Rectangles rectangles;
    const float cosines[] = {0.05f, 0.45f, 0.55f, 0.95f, -0.95f};
    for (int i = 0; i < 5; ++i)
        rectangles.add(10 + 30 * i, 10, 20, 100, 0, normalAt(cosines[i]));
    const QColor middle((paper.red() + shade.red()) / 2, (paper.green() + shade.green()) / 2,
                        (paper.blue() + shade.blue()) / 2);
    const QImage picture = painted(rectangles, appearanceOf(SurfaceAppearance::Toon));
    const QColor expected[] = {shade, middle, middle, paper, paper};
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(colorAt(picture, 20 + 30 * i, 60), expected[i]) << cosines[i];
    canvas_.clear();
    const QImage two = painted(rectangles, appearanceOf(SurfaceAppearance::Toon, 2));
    EXPECT_EQ(colorAt(two, 20 + 30, 60), shade);
    EXPECT_EQ(colorAt(two, 20 + 90, 60), paper);
}

/// With hardly a pixel in between.
TEST_F(SurfacePaintingTest, HasAsManyTonesAsAsked) {
    for (int tones : {2, 5, 8}) {
        Rectangles rectangles;
        for (int x = 0; x < Canvas::width; ++x)
            rectangles.add(x, 0, 1, Canvas::height, 0, normalAt((float(x) + 0.5f) / 160));
        canvas_.clear();
        const QImage picture = painted(rectangles, appearanceOf(SurfaceAppearance::Toon, tones));
        std::map<QRgb, int> columns;
        for (int x = 0; x < Canvas::width; ++x)
            ++columns[colorAt(picture, x, 60).rgb()];
        const auto is_broad = [](const auto& entry) { return entry.second > 3; };
        EXPECT_EQ(std::count_if(columns.begin(), columns.end(), is_broad), tones);
        EXPECT_EQ(colorAt(picture, 0, 60), shade);
        EXPECT_EQ(colorAt(picture, Canvas::width - 1, 60), paper);
    }
}

TEST_F(SurfacePaintingTest, LeavesWhatIsNearer) {
    canvas_.putDepth(0, 0, 80, Canvas::height, 0.5);
    Rectangles rectangles;
    rectangles.add(0, 0, 160, 120, 0);
    const QImage picture = painted(rectangles, appearanceOf(SurfaceAppearance::Paper));
    EXPECT_EQ(colorAt(picture, 40, 60), QColor(Qt::white));
    EXPECT_EQ(colorAt(picture, 120, 60), paper);
}

/// Wires and points that stand out slightly are covered.
TEST_F(SurfacePaintingTest, CoversWhatStandsOutOfTheSurface) {
    canvas_.putDepth(0, 0, 80, Canvas::height, 0.0004);
    canvas_.putDepth(80, 0, 80, Canvas::height, 0.0016);
    Rectangles rectangles;
    rectangles.add(0, 0, 160, 120, 0);
    const QImage picture = painted(rectangles, appearanceOf(SurfaceAppearance::Paper));
    EXPECT_EQ(colorAt(picture, 40, 60), paper);
    EXPECT_EQ(colorAt(picture, 120, 60), QColor(Qt::white));
}

/// In any order.
TEST_F(SurfacePaintingTest, PaintsTheNearestFacesOfTheTexture) {
    Rectangles rectangles;
    rectangles.add(0, 0, 160, 120, 0.4, normalAt(0.95f));
    rectangles.add(40, 0, 80, 120, -0.4, normalAt(0.05f));
    surface_ = rectangles.surface();
    line_renderer::SurfaceDepth depth;
    const DepthTexture texture = depth.update({layerOf(surface_)}, buffers_);
    const QImage picture = painted(rectangles, appearanceOf(SurfaceAppearance::Toon), texture);
    EXPECT_EQ(colorAt(picture, 20, 60), paper);
    EXPECT_EQ(colorAt(picture, 80, 60), paper);
}

TEST_F(SurfacePaintingTest, WritesNoDepth) {
    Rectangles rectangles;
    rectangles.add(0, 0, 160, 120, 0);
    painted(rectangles, appearanceOf(SurfaceAppearance::Paper));
    GLfloat depth = 0;
    glReadPixels(80, 60, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    EXPECT_EQ(depth, 1);
}

using BackgroundTest = GlTest;

TEST_F(BackgroundTest, IsWhereNothingIs) {
    canvas_.putDepth(30, 20, 50, 40, 0.5);
    canvas_.putDepth(100, 20, 20, 40, -0.999);
    line_renderer::BackgroundRenderer().paint(paper);
    const QImage picture = canvas_.picture();
    for (int x = 0; x < Canvas::width; ++x)
        for (int y = 0; y < Canvas::height; ++y) {
            const bool is_left = x >= 30 && x < 80 && y >= 20 && y < 60;
            const bool is_right = x >= 100 && x < 120 && y >= 20 && y < 60;
            ASSERT_EQ(colorAt(picture, x, y), is_left || is_right ? QColor(Qt::white) : paper)
                << x << ", " << y;
        }
}

/// Snapshots without background stay so.
TEST_F(BackgroundTest, LeavesAlphaAndDepth) {
    canvas_.clear(0);
    line_renderer::BackgroundRenderer().paint(paper);
    GLubyte pixel[4];
    glReadPixels(80, 60, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    EXPECT_EQ(pixel[0], paper.red());
    EXPECT_EQ(pixel[3], 0);
    GLfloat depth = 0;
    glReadPixels(80, 60, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    EXPECT_EQ(depth, 1);
}

}  // namespace
