// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/surface_depth.h"
#include "gl_test.h"

namespace {

using line_renderer::DepthTexture;
using line_renderer::SurfaceLayer;
using line_renderer::SurfacePointer;

constexpr float kTiny = 1e-6f;

/// A texture's values at the canvas's pixels.
class Depths {
public:
    explicit Depths(const DepthTexture& texture) {
        glBindTexture(GL_TEXTURE_2D, texture.id);
        GLint columns = 0, rows = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &columns);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &rows);
        EXPECT_FLOAT_EQ(texture.texel.x() * float(columns), 1);
        EXPECT_FLOAT_EQ(texture.texel.y() * float(rows), 1);
        columns_ = columns;
        depths_.resize(std::size_t(columns) * std::size_t(rows));
        glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths_.data());
        glBindTexture(GL_TEXTURE_2D, 0);
    }
    float at(int x, int y) const { return depths_.at(std::size_t(y * columns_ + x)); }

private:
    int columns_ = 0;
    std::vector<float> depths_;
};

class SurfaceDepthTest : public GlTest {
protected:
    line_renderer::SurfaceBuffers buffers_;
    line_renderer::SurfaceDepth depth_;
};

/// A layer's lines must not hide the next one's, and copying takes time.
TEST_F(SurfaceDepthTest, CopiesOnceARedraw) {
    depth_.copy();
    canvas_.put_depth(0, 0, Canvas::width, Canvas::height, 0.5);
    EXPECT_EQ(Depths(depth_.copy()).at(80, 60), 1);
    depth_.forget_depth_buffer();
    EXPECT_NEAR(Depths(depth_.copy()).at(80, 60), Canvas::depth_of(0.5), kTiny);
}

TEST_F(SurfaceDepthTest, CopiesTheViewportWhereverItIs) {
    canvas_.put_depth(100, 70, 60, 50, 0.5);
    glViewport(100, 70, 20, 10);
    EXPECT_NEAR(Depths(depth_.copy()).at(110, 75), Canvas::depth_of(0.5), kTiny);
    // Another viewport in the same redraw, as large as possible.
    glViewport(0, 0, Canvas::width, Canvas::height);
    const Depths depths(depth_.copy());
    EXPECT_EQ(depths.at(10, 10), 1);
    EXPECT_NEAR(depths.at(159, 119), Canvas::depth_of(0.5), kTiny);
}

TEST_F(SurfaceDepthTest, CannotCopySeveralSamplesAPixel) {
    EXPECT_TRUE(line_renderer::SurfaceDepth::can_copy());
    const Canvas smooth(4);
    EXPECT_FALSE(line_renderer::SurfaceDepth::can_copy());
}

TEST_F(SurfaceDepthTest, DrawsTheNearestOfAllLayers) {
    const SurfacePointer surfaces[] = {Rectangles().add(20, 20, 40, 40, 0.5).surface(),
                                       Rectangles().add(0, 0, 100, 120, -0.5).surface()};
    SurfaceLayer moved = layer_of(surfaces[0]);
    moved.transform(0, 3) = 60;
    canvas_.put_depth(0, 0, Canvas::width, Canvas::height, 0.9);
    const DepthTexture texture = depth_.update({moved, layer_of(surfaces[1])}, buffers_);
    EXPECT_FALSE(texture.is_complete);
    const Depths depths(texture);
    EXPECT_NEAR(depths.at(90, 30), Canvas::depth_of(0.5), kTiny);
    EXPECT_NEAR(depths.at(30, 30), Canvas::depth_of(-0.5), kTiny);
    EXPECT_EQ(depths.at(150, 110), 1) << "the depth buffer does not count";
    EXPECT_NEAR(Depths(depth_.copy()).at(150, 110), Canvas::depth_of(0.9), kTiny)
        << "and is left as it was";
}

TEST_F(SurfaceDepthTest, LeavesOutBackFacesWhereTheyAreCulled) {
    const SurfacePointer surface = Rectangles().add(0, 0, 160, 120, 0.5).surface();
    SurfaceLayer layer = layer_of(surface);
    layer.culls_back_faces = true;
    EXPECT_NEAR(Depths(depth_.update({layer}, buffers_)).at(80, 60), Canvas::depth_of(0.5), kTiny);
    glFrontFace(GL_CW);
    layer.transform(0, 3) = 1;  // something has changed
    EXPECT_EQ(Depths(depth_.update({layer}, buffers_)).at(80, 60), 1);
    layer.culls_back_faces = false;
    EXPECT_NEAR(Depths(depth_.update({layer}, buffers_)).at(80, 60), Canvas::depth_of(0.5), kTiny);
}

/// The texture is drawn anew only after changes.
TEST_F(SurfaceDepthTest, FollowsLayersCameraAndViewport) {
    const SurfacePointer surface = Rectangles().add(0, 0, 160, 120, 0.5).surface();
    SurfaceLayer layer = layer_of(surface);
    const auto expect = [&](double z, const char* after) {
        const DepthTexture texture = depth_.update({layer}, buffers_);
        EXPECT_NEAR(Depths(texture).at(50, 50), Canvas::depth_of(z), kTiny) << after;
        const float mark = 0.125f;
        glBindTexture(GL_TEXTURE_2D, texture.id);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 50, 50, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &mark);
        EXPECT_NEAR(Depths(depth_.update({layer}, buffers_)).at(50, 50), mark, kTiny) << "again";
    };
    expect(0.5, "at first");
    layer.transform(2, 3) = 0.25;
    expect(0.75, "a move of the layer");
    glScaled(1, 1, 0.5);
    expect(0.375, "a move of the camera");
    glViewport(0, 0, 100, 100);
    expect(0.375, "another viewport");
    depth_.copy();
    expect(0.375, "a copy in the same texture");
}

TEST_F(SurfaceDepthTest, IsEmptyWhereASurfaceIsGone) {
    const SurfaceLayer gone = layer_of(Rectangles().add(0, 0, 160, 120, 0.5).surface());
    EXPECT_EQ(Depths(depth_.update({gone}, buffers_)).at(80, 60), 1);
}

}  // namespace
