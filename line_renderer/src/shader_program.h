// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "gl_functions.h"

namespace line_renderer {

/// Attributes get their indices in `attributes` as locations. The program belongs to the current
/// share group. @throws std::runtime_error: `refusal`, such as "Lines cannot be drawn", and the
/// reason: no shaders (OpenGL 2.0), or the compiler's message
GLuint buildShaderProgram(const char* refusal, const char* vertex_shader,
                          const char* fragment_shader,
                          const std::vector<const char*>& attributes = {});

}  // namespace line_renderer
