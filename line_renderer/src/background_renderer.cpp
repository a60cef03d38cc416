// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/background_renderer.h"

#include "gl_state.h"
#include "shader_program.h"

namespace line_renderer {
namespace {

// At the depth that an empty view has.
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

BackgroundRenderer::Program& BackgroundRenderer::programOfCurrentGroup() {
    const ShareGroup group = currentShareGroup();
    const auto [place, is_new] = groups_.try_emplace(group);
    if (is_new) whenGone(group, &receiver_, [this, group] { groups_.erase(group); });
    return place->second;
}

void BackgroundRenderer::build(Program& program) {
    if (!GLEW_VERSION_2_0) {
        program.failure = "shaders (OpenGL 2.0) are not available";
        return;
    }
    program.id = buildShaderProgram(vertex_shader, fragment_shader, {}, program.failure);
    if (program.id) program.color = glGetUniformLocation(program.id, "color");
}

std::string BackgroundRenderer::paint(const QColor& color) {
    Program& program = programOfCurrentGroup();
    if (!program.id && program.failure.empty()) build(program);
    if (!program.id) return "The background cannot be painted: " + program.failure;

    const LineGlState state;
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    glUseProgram(program.id);
    glUniform4f(program.color, float(color.redF()), float(color.greenF()), float(color.blueF()), 1);
    glRectf(-1, -1, 1, 1);
    return {};
}

}  // namespace line_renderer
