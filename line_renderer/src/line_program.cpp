// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_program.h"

#include "shaders.h"

namespace line_renderer {

LineProgram::LineProgram()
    : id(buildShaderProgram(
          "Lines cannot be drawn", line_vertex_shader, line_fragment_shader,
          {"corner", "before", "start", "end", "after", "start_look", "end_look"})),
      to_eye(glGetUniformLocation(id, "to_eye")),
      projection(glGetUniformLocation(id, "projection")),
      half_viewport(glGetUniformLocation(id, "half_viewport")),
      depth_biases(glGetUniformLocation(id, "depth_biases")),
      mark_reach(glGetUniformLocation(id, "mark_reach")),
      surface_depth(glGetUniformLocation(id, "surface_depth")),
      texel(glGetUniformLocation(id, "texel")),
      pixels(glGetUniformLocation(id, "pixels")),
      to_side(glGetUniformLocation(id, "to_side")),
      edge_reach(glGetUniformLocation(id, "edge_reach")),
      surface_side(glGetUniformLocation(id, "surface_side")),
      colors(glGetUniformLocation(id, "colors")),
      dash(glGetUniformLocation(id, "dash")) {}

}  // namespace line_renderer
