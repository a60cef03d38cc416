// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "gl_functions.h"

namespace line_renderer {

/// Builds a program whose attributes have their places in `attributes` as locations. Needs a
/// current context; the program belongs to its share group.
/// @throws std::runtime_error that begins with `refusal`, as "Lines cannot be drawn", and ends with
/// the reason, if there are no shaders (OpenGL 2.0) or in the compiler's words
GLuint buildShaderProgram(const char* refusal, const char* vertex_shader,
                          const char* fragment_shader,
                          const std::vector<const char*>& attributes = {});

}  // namespace line_renderer
