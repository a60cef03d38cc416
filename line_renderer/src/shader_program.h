// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/glew.h>

#include <string>
#include <vector>

namespace line_renderer {

/// Builds a program whose attributes have their places in `attributes` as locations. 0 on failure,
/// with the compiler's words added to `failure`. Needs a current context with OpenGL 2.0; the
/// program belongs to its share group.
GLuint buildShaderProgram(const char* vertex_shader, const char* fragment_shader,
                          const std::vector<const char*>& attributes, std::string& failure);

}  // namespace line_renderer
