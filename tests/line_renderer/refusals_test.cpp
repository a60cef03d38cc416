// SPDX-License-Identifier: GPL-3.0-or-later
// What OpenGL lacks is refused with a reason; programs that fail are not compiled again; extensions
// of older versions are used.
#include "gl_functions.h"
#include "gl_test.h"
#include "line_renderer/surface_renderer.h"

namespace {

using line_renderer::gl_features;
using line_renderer::LinePlacement;

int compiled = 0;
PFNGLCOMPILESHADERPROC compile_shader = nullptr;

void GLAPIENTRY count_compiled(GLuint shader) {
    ++compiled;
    compile_shader(shader);
}

PFNGLSHADERSOURCEPROC shader_source = nullptr;

void GLAPIENTRY spoil_source(GLuint shader, GLsizei, const GLchar* const*, const GLint*) {
    const GLchar* const nonsense = "#version 120\nvoid main() { no_such_thing = 1; }\n";
    shader_source(shader, 1, &nonsense, nullptr);
}

/// Hides a feature of OpenGL while it lives.
struct Without : Replaced<bool> {
    explicit Without(bool& feature) : Replaced(feature, false) {}
};

/// The refusal's message, or nothing.
template <class Call>
std::string refusal_of(Call call) {
    try {
        call();
    } catch (const std::runtime_error& refusal) {
        return refusal.what();
    }
    return {};
}

class RefusalsTest : public LineTest {
protected:
    RefusalsTest() : counted_(line_renderer::glCompileShader.pointer(), count_compiled) {
        compile_shader = counted_.before();
        compiled = 0;
    }

    QImage draw_line() { return drawn(one_line({{9, 9, 0}, {90, 80, 0}}), black_lines(3)); }

    Replaced<PFNGLCOMPILESHADERPROC> counted_;
};

TEST_F(RefusalsTest, ProgramsThatFailAreCompiledOnce) {
    const auto surface = Rectangles().add(20, 20, 90, 70, 0).surface();
    line_renderer::SurfaceBuffers buffers;
    line_renderer::SurfaceRenderer surfaces;
    const auto paint_surface = [&] {
        surfaces.paint(layer_of(surface), {}, Eigen::Matrix4d::Identity(), depth_.copy(), buffers);
    };
    const auto paint_background = [&] { surfaces.paint_background(); };
    std::string refusals[3];
    {
        const Replaced<PFNGLSHADERSOURCEPROC> spoilt(line_renderer::glShaderSource.pointer(),
                                                     spoil_source);
        shader_source = spoilt.before();
        refusals[0] = refusal_of([&] { draw_line(); });
        refusals[1] = refusal_of(paint_surface);
        refusals[2] = refusal_of(paint_background);
    }
    const char* const beginnings[] = {"Lines cannot be drawn: ", "The surface cannot be painted: ",
                                      "The background cannot be painted: "};
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(refusals[i].rfind(beginnings[i], 0), 0u) << refusals[i];
        EXPECT_NE(refusals[i].find("no_such_thing"), std::string::npos) << refusals[i];
    }
    EXPECT_GT(compiled, 0);
    compiled = 0;
    for (int redraw = 0; redraw < 3; ++redraw) {
        EXPECT_EQ(refusal_of([&] { draw_line(); }), refusals[0]);
        EXPECT_EQ(refusal_of(paint_surface), refusals[1]);
        EXPECT_EQ(refusal_of(paint_background), refusals[2]);
    }
    EXPECT_EQ(compiled, 0);
    EXPECT_EQ(ink_of(canvas_.picture()), 0);
}

TEST_F(RefusalsTest, LinesNeedInstancedDrawing) {
    const Without instancing(gl_features().instancing), old(gl_features().old_instancing);
    EXPECT_EQ(refusal_of([&] { draw_line(); }),
              "Lines cannot be drawn: instanced drawing (OpenGL 3.3) is not available.");
}

TEST_F(RefusalsTest, DepthsOfSurfacesNeedFramebuffers) {
    const Without framebuffers(gl_features().framebuffers);
    line_renderer::SurfaceBuffers buffers;
    EXPECT_EQ(refusal_of([&] { depth_.update({}, buffers); }),
              "Lines over points and wires need framebuffer objects (OpenGL 3.0): show the layer "
              "filled.");
}

TEST_F(RefusalsTest, LinesWithoutMemoryAreNotDrawn) {
    const QImage expected = draw_line();
    canvas_.clear();
    {
        const Replaced<PFNGLMAPBUFFERRANGEPROC> full(
            line_renderer::glMapBufferRange.pointer(),
            [](GLenum, GLintptr, GLsizeiptr, GLbitfield) -> void* { return nullptr; });
        EXPECT_EQ(refusal_of([&] { draw_line(); }),
                  "Lines cannot be drawn: OpenGL has no memory for them.");
        LinePlacement placement = Canvas::placement();
        placement.depths = depth_.copy();
        line_renderer::RedrawClock clock;
        renderer_.draw(black_lines(3), placement, clock);
        EXPECT_EQ(ink_of(canvas_.picture()), 0);
    }
    EXPECT_EQ(draw_line(), expected) << "the next try may succeed";
}

/// By extensions of OpenGL 2.
TEST_F(RefusalsTest, OlderVersionsDrawTheSame) {
    const QImage expected = draw_line();
    ASSERT_GT(ink_of(expected), 100);
    canvas_.clear();
    const Without instancing(gl_features().instancing), ranges(gl_features().buffer_ranges),
        array_objects(gl_features().array_objects);
    EXPECT_EQ(draw_line(), expected);
}

}  // namespace
