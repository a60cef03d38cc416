// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing restores OpenGL's state.
#include "gl_state_text.h"
#include "line_renderer/background_renderer.h"
#include "line_renderer/surface_renderer.h"
#include "line_test.h"

namespace {

using line_renderer::HiddenLines;

GLuint boundBuffer(GLenum target) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    return buffer;
}

/// To what neither drawing nor defaults use.
void makeStateUnusual() {
    boundBuffer(GL_ELEMENT_ARRAY_BUFFER);
    glEnableVertexAttribArray(1);
    glEnableVertexAttribArray(9);
    boundBuffer(GL_ARRAY_BUFFER);
    glVertexPointer(2, GL_SHORT, 12, nullptr);
    glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, 24, nullptr);
    boundBuffer(GL_ARRAY_BUFFER);
    for (GLenum array : {GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY})
        glEnableClientState(array);
    for (GLenum feature : {GL_CULL_FACE, GL_LIGHTING, GL_POLYGON_OFFSET_FILL, GL_ALPHA_TEST})
        glEnable(feature);
    glAlphaFunc(GL_GREATER, 0.99f);
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glClearDepth(0.25);
    glBlendFuncSeparate(GL_ONE, GL_ZERO, GL_DST_COLOR, GL_ONE);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glCullFace(GL_FRONT);
    glMatrixMode(GL_TEXTURE);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glActiveTexture(GL_TEXTURE2);
    glColor4f(0.1f, 0.2f, 0.3f, 0.4f);
}

/// Not in the text: array pointers, and the first unit's texture.
std::vector<GLint> arrays() {
    std::vector<GLint> values;
    for (GLenum name : {GL_VERTEX_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE,
                        GL_VERTEX_ARRAY_STRIDE, GL_NORMAL_ARRAY_BUFFER_BINDING,
                        GL_NORMAL_ARRAY_STRIDE, GL_DEPTH_CLEAR_VALUE}) {
        values.push_back(0);
        glGetIntegerv(name, &values.back());
    }
    for (GLuint i = 0; i < 16; ++i)
        for (GLenum name : {GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, GL_VERTEX_ATTRIB_ARRAY_SIZE,
                            GL_VERTEX_ATTRIB_ARRAY_STRIDE, GL_VERTEX_ATTRIB_ARRAY_DIVISOR}) {
            values.push_back(0);
            glGetVertexAttribiv(i, name, &values.back());
        }
    GLint unit = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
    glActiveTexture(GL_TEXTURE0);
    values.push_back(0);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &values.back());
    glActiveTexture(GLenum(unit));
    return values;
}

class GlStateTest : public LineTest {
protected:
    /// Twice: the first call also creates objects.
    template <class Draw>
    void expectSameState(const char* what, Draw draw) {
        for (const char* time : {"first", "second"}) {
            const std::string before = glStateText().toStdString();
            const std::vector<GLint> arrays_before = arrays();
            draw();
            EXPECT_EQ(glStateText().toStdString(), before) << what << ", " << time;
            EXPECT_EQ(arrays(), arrays_before) << what << ", " << time;
        }
    }

    void expectSameStateWhateverIsDrawn() {
        Rectangles rectangles;
        rectangles.add(20, 20, 90, 70, 0);
        const line_renderer::SurfacePointer surface = rectangles.surface();
        expectSameState("background", [&] { background_.paint(); });
        expectSameState("copy of depths", [&] {
            depth_.forgetDepthBuffer();
            depth_.copy();
        });
        expectSameState("surface", [&] {
            surfaces_.paint(layerOf(surface), line_renderer::SurfaceStyle::Toon,
                            Eigen::Matrix4d::Identity(), depth_.copy(), buffers_);
        });
        expectSameState("depths", [&] {
            depth_.copy();
            depth_.update({layerOf(surface)}, buffers_);
        });
        for (HiddenLines hidden : {HiddenLines::LeftOut, HiddenLines::Faint, HiddenLines::Dashed}) {
            line_renderer::LineAppearance appearance = blackLines(3);
            appearance.hidden = hidden;
            expectSameState("lines", [&] { drawn(oneLine({{9, 9, 0}, {90, 80, 0}}), appearance); });
        }
    }

    line_renderer::BackgroundRenderer background_;
    line_renderer::SurfaceRenderer surfaces_;
    line_renderer::SurfaceBuffers buffers_;
};

TEST_F(GlStateTest, IsAsItWas) {
    expectSameStateWhateverIsDrawn();
}

TEST_F(GlStateTest, IsAsItWasHoweverUnusual) {
    makeStateUnusual();
    expectSameStateWhateverIsDrawn();
}

TEST_F(GlStateTest, IsAsItWasInAnArrayObject) {
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    makeStateUnusual();
    expectSameStateWhateverIsDrawn();
}

/// Unusual state does not affect the picture.
TEST_F(GlStateTest, DoesNotChangeThePicture) {
    const laplacian_lines::LineSet lines = oneLine({{9, 9, 0}, {90, 80, 0}});
    const QImage usual = drawn(lines, blackLines(3));
    ASSERT_LT(colorAt(usual, 9, 9).greenF(), 0.1);
    canvas_.clear();
    makeStateUnusual();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);  // the caller's
    EXPECT_EQ(drawn(lines, blackLines(3)), usual);
}

}  // namespace
