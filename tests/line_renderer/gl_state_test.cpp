// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing restores OpenGL's state.
#include <map>

#include "gl_test.h"
#include "line_renderer/picture_renderer.h"
#include "line_renderer/surface_renderer.h"

namespace {

using line_renderer::HiddenLines;

void bind_new_buffer(GLenum target) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
}

/// To other than a new canvas has.
void make_state_unusual() {
    bind_new_buffer(GL_ELEMENT_ARRAY_BUFFER);
    glEnableVertexAttribArray(1);
    glEnableVertexAttribArray(9);
    bind_new_buffer(GL_ARRAY_BUFFER);
    glVertexPointer(2, GL_SHORT, 12, nullptr);
    glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, 24, nullptr);
    bind_new_buffer(GL_ARRAY_BUFFER);
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
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 7);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 3);
    glMatrixMode(GL_TEXTURE);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glActiveTexture(GL_TEXTURE2);
    glColor4f(0.1f, 0.2f, 0.3f, 0.4f);
}

/// What drawing depends on, by OpenGL's number of its name.
using State = std::map<GLenum, std::vector<double>>;
using Names = std::initializer_list<GLenum>;

State current_state() {
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    State state;
    const Names switches[] = {
        {GL_ALPHA_TEST, GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_LIGHTING, GL_TEXTURE_2D},
        {GL_COLOR_LOGIC_OP, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_FOG, GL_MULTISAMPLE},
        {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_LINE_SMOOTH, GL_POINT_SMOOTH},
        {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY},
        {GL_LINE_STIPPLE, GL_NORMALIZE, GL_CLIP_PLANE0, GL_PRIMITIVE_RESTART}};
    for (const Names& names : switches)
        for (GLenum name : names)
            state[name] = {double(glIsEnabled(name))};
    const Names values[] = {
        {GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING},
        {GL_VERTEX_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE},
        {GL_VERTEX_ARRAY_STRIDE, GL_NORMAL_ARRAY_BUFFER_BINDING, GL_NORMAL_ARRAY_STRIDE},
        {GL_BLEND_DST_ALPHA, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_SRC_RGB},
        {GL_BLEND_EQUATION_RGB, GL_COLOR_WRITEMASK, GL_CURRENT_COLOR, GL_CURRENT_NORMAL},
        {GL_DEPTH_FUNC, GL_DEPTH_RANGE, GL_DEPTH_WRITEMASK, GL_DEPTH_CLEAR_VALUE},
        {GL_CULL_FACE_MODE, GL_FRONT_FACE, GL_POLYGON_MODE, GL_POLYGON_OFFSET_FACTOR},
        {GL_POLYGON_OFFSET_UNITS, GL_SHADE_MODEL, GL_LINE_WIDTH, GL_POINT_SIZE, GL_VIEWPORT},
        {GL_MATRIX_MODE, GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_MODELVIEW_STACK_DEPTH},
        {GL_PROJECTION_STACK_DEPTH, GL_ATTRIB_STACK_DEPTH, GL_CLIENT_ATTRIB_STACK_DEPTH},
        {GL_CURRENT_PROGRAM, GL_ACTIVE_TEXTURE, GL_CLIENT_ACTIVE_TEXTURE, GL_TEXTURE_BINDING_2D},
        {GL_DRAW_BUFFER, GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING},
        {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_PIXELS},
        {GL_UNPACK_SKIP_ROWS}};
    for (const Names& names : values)
        for (GLenum name : names) {
            state[name].resize(16);  // of one number, or as many as a matrix has
            glGetDoublev(name, state[name].data());
        }
    for (GLenum name : {GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_DIVISOR,
                        GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, GL_VERTEX_ATTRIB_ARRAY_SIZE,
                        GL_VERTEX_ATTRIB_ARRAY_STRIDE})
        for (GLuint i = 0; i < 16; ++i) {  // there are at least so many
            GLint value = 0;
            glGetVertexAttribiv(i, name, &value);
            state[name].push_back(value);
        }
    GLint unit = 0, texture = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
    glActiveTexture(GL_TEXTURE0);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
    glActiveTexture(GLenum(unit));
    state[GL_TEXTURE0] = {double(texture)};
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << "this context does not know all the names";
    return state;
}

class GlStateTest : public LineTest {
protected:
    /// Twice: the first call also creates objects.
    template <class Draw>
    void expect_same_state(const char* what, Draw draw) {
        for (const char* time : {"first", "second"}) {
            const State before = current_state();
            draw();
            for (const auto& [name, value] : current_state())
                EXPECT_EQ(value, before.at(name))
                    << what << ", " << time << ": state 0x" << std::hex << name;
        }
    }

    void expect_same_state_whatever_is_drawn() {
        const auto surface = Rectangles().add(20, 20, 90, 70, 0).surface();
        expect_same_state("background", [&] { surfaces_.paint_background(); });
        expect_same_state("copy of depths", [&] {
            depth_.forget_depth_buffer();
            depth_.copy();
        });
        expect_same_state("surface", [&] {
            surfaces_.paint(layer_of(surface), line_renderer::SurfaceStyle::Toon,
                            Eigen::Matrix4d::Identity(), depth_.copy(), buffers_);
        });
        expect_same_state("depths", [&] {
            depth_.copy();
            depth_.update({layer_of(surface)}, buffers_);
        });
        const line_renderer::InkPicture picture = {
            {Canvas::width + 5, Canvas::height + 7},
            {std::vector<std::uint8_t>((Canvas::width + 5) * (Canvas::height + 7))}};
        expect_same_state("picture", [&] { pictures_.paint(picture, {Qt::black}, {5, 7}); });
        for (HiddenLines hidden : {HiddenLines::LeftOut, HiddenLines::Faint, HiddenLines::Dashed}) {
            line_renderer::LineAppearance appearance = black_lines(3);
            appearance.hidden = hidden;
            expect_same_state("lines", [&] {
                drawn(one_line({{9, 9, 0}, {90, 80, 0}}), appearance);
            });
        }
    }

    line_renderer::SurfaceRenderer surfaces_;
    line_renderer::SurfaceBuffers buffers_;
    line_renderer::PictureRenderer pictures_;
};

TEST_F(GlStateTest, IsAsItWas) {
    expect_same_state_whatever_is_drawn();
}

TEST_F(GlStateTest, IsAsItWasHoweverUnusual) {
    make_state_unusual();
    expect_same_state_whatever_is_drawn();
}

TEST_F(GlStateTest, IsAsItWasInAnArrayObject) {
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    make_state_unusual();
    expect_same_state_whatever_is_drawn();
}

/// Unusual state does not affect the picture.
TEST_F(GlStateTest, DoesNotChangeThePicture) {
    const laplacian_lines::LineSet lines = one_line({{9, 9, 0}, {90, 80, 0}});
    const QImage usual = drawn(lines, black_lines(3));
    ASSERT_LT(color_at(usual, 9, 9).greenF(), 0.1);
    canvas_.clear();
    make_state_unusual();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);  // the caller's
    EXPECT_EQ(drawn(lines, black_lines(3)), usual);
}

}  // namespace
