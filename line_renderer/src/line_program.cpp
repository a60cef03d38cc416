// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/line_program.h"

#include "line_shaders.h"
#include "shader_program.h"

namespace line_renderer {

LineProgram buildLineProgram() {
    LineProgram program;
    program.id = buildShaderProgram(
        line_vertex_shader, line_fragment_shader,
        {"corner", "before", "start", "end", "after", "start_look", "end_look"}, program.failure);
    if (!program.id) return program;
    program.to_eye = glGetUniformLocation(program.id, "to_eye");
    program.projection = glGetUniformLocation(program.id, "projection");
    program.half_viewport = glGetUniformLocation(program.id, "half_viewport");
    program.depth_bias = glGetUniformLocation(program.id, "depth_bias");
    program.mark_reach = glGetUniformLocation(program.id, "mark_reach");
    program.surface_depth = glGetUniformLocation(program.id, "surface_depth");
    program.texel = glGetUniformLocation(program.id, "texel");
    program.surface_side = glGetUniformLocation(program.id, "surface_side");
    program.pixels = glGetUniformLocation(program.id, "pixels");
    program.to_side = glGetUniformLocation(program.id, "to_side");
    program.color = glGetUniformLocation(program.id, "color");
    program.contour_color = glGetUniformLocation(program.id, "contour_color");
    program.dash = glGetUniformLocation(program.id, "dash");
    return program;
}

}  // namespace line_renderer
