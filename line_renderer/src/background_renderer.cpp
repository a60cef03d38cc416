// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/background_renderer.h"

#include "gl_state.h"
#include "per_share_group.h"
#include "shaders.h"

namespace line_renderer {
namespace {

// At the depth of an empty view.
const char* const vertex_shader = R"(#version 120
void main()
{
    gl_Position = vec4(gl_Vertex.xy, 1.0, 1.0);
}
)";

const char* const fragment_shader = R"(#version 120
uniform vec4 color;
void main()
{
    gl_FragColor = color;
}
)";

}  // namespace

struct BackgroundRenderer::Program {
    GLuint id =
        buildShaderProgram("The background cannot be painted", vertex_shader, fragment_shader);
    GLint color = glGetUniformLocation(id, "color");
};

BackgroundRenderer::BackgroundRenderer() : programs_(std::make_unique<PerShareGroup<Program>>()) {}

BackgroundRenderer::~BackgroundRenderer() = default;

void BackgroundRenderer::paint(const QColor& color) {
    const Program& program = programs_->current();
    const GlState state;
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    glUseProgram(program.id);
    glUniform4f(program.color, float(color.redF()), float(color.greenF()), float(color.blueF()), 1);
    glRectf(-1, -1, 1, 1);
}

}  // namespace line_renderer
