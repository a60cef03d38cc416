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

const QColor kPaper = Qt::white, kShade(150, 150, 150), kNothing = Qt::blue;

/// Unit, at this cosine to the ray.
Vector3f normal_at(float cosine) {
    return {std::sqrt(1 - cosine * cosine), 0, cosine};
}

class SurfacePaintingTest : public GlTest {
protected:
    SurfacePaintingTest() { canvas_.clear(1, kNothing); }

    QImage painted(const SurfacePointer& surface, SurfaceStyle style = SurfaceStyle::Paper,
                   const DepthTexture& depth = {0, {0, 0}, true}) {
        renderer_.paint(layer_of(surface), style, Eigen::Matrix4d::Identity(), depth, buffers_);
        return canvas_.picture();
    }

    line_renderer::SurfaceBuffers buffers_;
    line_renderer::SurfaceRenderer renderer_;
};

TEST_F(SurfacePaintingTest, PaperIsWhiteAndNowhereElseAndHasNoDepth) {
    const QImage picture = painted(Rectangles()
                                       .add(10, 10, 50, 40, 0, normal_at(0.1f))
                                       .add(80, 20, 30, 70, 0.2, normal_at(1))
                                       .surface());
    for (int x = 0; x < Canvas::width; ++x)
        for (int y = 0; y < Canvas::height; ++y) {
            const bool is_left = x >= 10 && x < 60 && y >= 10 && y < 50;
            const bool is_right = x >= 80 && x < 110 && y >= 20 && y < 90;
            ASSERT_EQ(color_at(picture, x, y), is_left || is_right ? kPaper : kNothing)
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
            rectangles.add(x, 0, 1, Canvas::height, 0, normal_at(side * (float(x) + 0.5f) / 160));
        const QImage picture = painted(rectangles.surface(), SurfaceStyle::Toon);
        std::map<int, int> columns;
        for (int x = 0; x < Canvas::width; ++x)
            ++columns[color_at(picture, x, 60).green()];
        std::vector<int> wide;
        for (const auto& [tone, count] : columns)
            if (count > 3) wide.push_back(tone);  // others are the pixel between two tones
        ASSERT_EQ(wide.size(), 3u);
        EXPECT_EQ(wide[0], kShade.green());
        EXPECT_NEAR(wide[1], (kShade.green() + kPaper.green()) / 2., 2);
        EXPECT_EQ(wide[2], kPaper.green());
        EXPECT_EQ(color_at(picture, 0, 60), kShade);
        EXPECT_EQ(color_at(picture, Canvas::width - 1, 60), kPaper);
    }
}

/// But wires and points are covered that stand out by less than paint is moved towards the eye,
/// .0005 diagonals; the layer has a diagonal of 1.
TEST_F(SurfacePaintingTest, LeavesWhatIsNearer) {
    canvas_.put_depth(0, 0, 50, Canvas::height, 0.5);
    canvas_.put_depth(50, 0, 50, Canvas::height, 0.0004);
    canvas_.put_depth(100, 0, 60, Canvas::height, 0.0006);
    const QImage picture = painted(Rectangles().add(0, 0, 160, 120, 0).surface());
    EXPECT_EQ(color_at(picture, 25, 60), kNothing);
    EXPECT_EQ(color_at(picture, 75, 60), kPaper);
    EXPECT_EQ(color_at(picture, 125, 60), kNothing);
}

/// Of a mesh that was refined: MeshLab draws its flat faces.
TEST_F(SurfacePaintingTest, CurvedFacesCoverTheFlatOnesBeforeThem) {
    canvas_.put_depth(0, 0, 50, Canvas::height, 0.0021);
    canvas_.put_depth(50, 0, 50, Canvas::height, 0.0019);
    line_renderer::Surface curved = *Rectangles().add(0, 0, 160, 120, 0).surface();
    curved.most_behind = 0.002;
    const QImage picture = painted(std::make_shared<line_renderer::Surface>(curved));
    EXPECT_EQ(color_at(picture, 25, 60), kNothing);
    EXPECT_EQ(color_at(picture, 75, 60), kPaper);
}

/// Whichever is drawn last.
TEST_F(SurfacePaintingTest, PaintsTheNearestFacesOfTheTexture) {
    const SurfacePointer surface = Rectangles()
                                       .add(0, 0, 160, 120, 0.4, normal_at(0.95f))
                                       .add(40, 0, 80, 120, -0.4, normal_at(0.05f))
                                       .surface();
    line_renderer::SurfaceDepth depth;
    const DepthTexture texture = depth.update({layer_of(surface)}, buffers_);
    const QImage picture = painted(surface, SurfaceStyle::Toon, texture);
    EXPECT_EQ(color_at(picture, 20, 60), kPaper);
    EXPECT_EQ(color_at(picture, 80, 60), kPaper);
}

/// Snapshots without background stay so.
TEST_F(SurfacePaintingTest, BackgroundIsWhereNothingIsAndLeavesAlphaAndDepth) {
    canvas_.clear(0, kNothing);
    canvas_.put_depth(30, 20, 50, 40, 0.5);
    canvas_.put_depth(100, 20, 20, 40, -0.999);
    renderer_.paint_background();
    const QImage picture = canvas_.picture();
    for (int x = 0; x < Canvas::width; ++x)
        for (int y = 0; y < Canvas::height; ++y) {
            const bool is_left = x >= 30 && x < 80 && y >= 20 && y < 60;
            const bool is_right = x >= 100 && x < 120 && y >= 20 && y < 60;
            const QColor color = color_at(picture, x, y);
            ASSERT_EQ(color.rgb(), is_left || is_right ? kNothing.rgb() : kPaper.rgb())
                << x << ", " << y;
            ASSERT_EQ(color.alpha(), 0);
        }
    GLfloat depth = 0;
    glReadPixels(80, 60, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    EXPECT_EQ(depth, 1);
}

}  // namespace
