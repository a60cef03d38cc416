// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "gl_functions.h"

namespace line_renderer {

/// Attributes get their indices in `attributes` as locations. The program belongs to the current
/// share group. @throws std::runtime_error: `refusal`, such as "Lines cannot be drawn", and the
/// reason: no shaders (OpenGL 2.0), or the compiler's message
GLuint buildShaderProgram(const char* refusal, const char* vertex_shader,
                          const char* fragment_shader,
                          const std::vector<const char*>& attributes = {});

/// GLSL 1.20. Widens a segment to a quad in pixels, of which the fragment shader keeps the
/// segment's share of the line.
extern const char* const line_vertex_shader;
extern const char* const line_fragment_shader;

/// Looks that the shaders hold.
constexpr std::size_t most_looks = 16;

/// GLSL 1.20. Paints faces, slightly nearer to the eye, in flat tones by the angle between normal
/// and ray.
extern const char* const surface_vertex_shader;
extern const char* const surface_fragment_shader;

}  // namespace line_renderer
