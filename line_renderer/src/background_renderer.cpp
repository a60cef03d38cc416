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
void main()
{
    gl_FragColor = vec4(1.0);
}
)";

}  // namespace

struct BackgroundRenderer::Program {
    GLuint id =
        buildShaderProgram("The background cannot be painted", vertex_shader, fragment_shader);
};

BackgroundRenderer::BackgroundRenderer() : programs_(std::make_unique<PerShareGroup<Program>>()) {}

BackgroundRenderer::~BackgroundRenderer() = default;

void BackgroundRenderer::paint() {
    const GlState state;
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    glUseProgram(programs_->current().id);
    glRectf(-1, -1, 1, 1);
}

}  // namespace line_renderer
