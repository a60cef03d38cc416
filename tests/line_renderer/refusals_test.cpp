// SPDX-License-Identifier: GPL-3.0-or-later
// What OpenGL lacks is refused with a reason each time, without another try; older versions'
// extensions are used.
#include "gl_functions.h"
#include "gl_test.h"
#include "line_renderer/surface_renderer.h"

namespace {

using line_renderer::glFeatures;
using line_renderer::LinePlacement;

int compiled = 0;
PFNGLCOMPILESHADERPROC compile_shader = nullptr;

void GLAPIENTRY countCompiled(GLuint shader) {
    ++compiled;
    compile_shader(shader);
}

PFNGLSHADERSOURCEPROC shader_source = nullptr;

void GLAPIENTRY spoilSource(GLuint shader, GLsizei, const GLchar* const*, const GLint*) {
    const GLchar* const nonsense = "#version 120\nvoid main() { no_such_thing = 1; }\n";
    shader_source(shader, 1, &nonsense, nullptr);
}

/// Hides a feature of OpenGL while it lives.
struct Without : Replaced<bool> {
    explicit Without(bool& feature) : Replaced(feature, false) {}
};

/// The refusal's message, or nothing.
template <class Call>
std::string refusalOf(Call call) {
    try {
        call();
    } catch (const std::runtime_error& refusal) {
        return refusal.what();
    }
    return {};
}

class RefusalsTest : public LineTest {
protected:
    RefusalsTest() : counted_(line_renderer::glCompileShader.pointer(), countCompiled) {
        compile_shader = counted_.before();
        compiled = 0;
    }

    QImage drawLine() { return drawn(oneLine({{9, 9, 0}, {90, 80, 0}}), blackLines(3)); }

    Replaced<PFNGLCOMPILESHADERPROC> counted_;
};

TEST_F(RefusalsTest, ProgramsThatFailAreCompiledOnce) {
    Rectangles rectangles;
    rectangles.add(20, 20, 90, 70, 0);
    const line_renderer::SurfacePointer surface = rectangles.surface();
    line_renderer::SurfaceBuffers buffers;
    line_renderer::SurfaceRenderer surfaces;
    const auto paintSurface = [&] {
        surfaces.paint(layerOf(surface), {}, Eigen::Matrix4d::Identity(), depth_.copy(), buffers);
    };
    const auto paintBackground = [&] { surfaces.paintBackground(); };
    std::string refusals[3];
    {
        const Replaced<PFNGLSHADERSOURCEPROC> spoilt(line_renderer::glShaderSource.pointer(),
                                                     spoilSource);
        shader_source = spoilt.before();
        refusals[0] = refusalOf([&] { drawLine(); });
        refusals[1] = refusalOf(paintSurface);
        refusals[2] = refusalOf(paintBackground);
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
        EXPECT_EQ(refusalOf([&] { drawLine(); }), refusals[0]);
        EXPECT_EQ(refusalOf(paintSurface), refusals[1]);
        EXPECT_EQ(refusalOf(paintBackground), refusals[2]);
    }
    EXPECT_EQ(compiled, 0);
    EXPECT_EQ(inkOf(canvas_.picture()), 0);
}

TEST_F(RefusalsTest, LinesNeedInstancedDrawing) {
    const Without instancing(glFeatures().instancing), old(glFeatures().old_instancing);
    EXPECT_EQ(refusalOf([&] { drawLine(); }),
              "Lines cannot be drawn: instanced drawing (OpenGL 3.3) is not available.");
}

TEST_F(RefusalsTest, DepthsOfSurfacesNeedFramebuffers) {
    const Without framebuffers(glFeatures().framebuffers);
    line_renderer::SurfaceBuffers buffers;
    EXPECT_EQ(refusalOf([&] { depth_.update({}, buffers); }),
              "Lines over points and wires need framebuffer objects (OpenGL 3.0): show the layer "
              "filled.");
}

TEST_F(RefusalsTest, LinesWithoutMemoryAreNotDrawn) {
    const QImage expected = drawLine();
    canvas_.clear();
    {
        const Replaced<PFNGLMAPBUFFERRANGEPROC> full(
            line_renderer::glMapBufferRange.pointer(),
            [](GLenum, GLintptr, GLsizeiptr, GLbitfield) -> void* { return nullptr; });
        EXPECT_EQ(refusalOf([&] { drawLine(); }),
                  "Lines cannot be drawn: OpenGL has no memory for them.");
        LinePlacement placement = Canvas::placement();
        placement.depths = depth_.copy();
        line_renderer::RedrawClock clock;
        renderer_.draw(blackLines(3), placement, clock);
        EXPECT_EQ(inkOf(canvas_.picture()), 0);
    }
    EXPECT_EQ(drawLine(), expected) << "the next try may succeed";
}

/// By extensions of OpenGL 2.
TEST_F(RefusalsTest, OlderVersionsDrawTheSame) {
    const QImage expected = drawLine();
    ASSERT_GT(inkOf(expected), 100);
    canvas_.clear();
    const Without instancing(glFeatures().instancing), ranges(glFeatures().buffer_ranges),
        array_objects(glFeatures().array_objects);
    EXPECT_EQ(drawLine(), expected);
}

}  // namespace
