// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl_functions.h"

namespace line_renderer {

/// Instanced drawing, by OpenGL 3.3 or by the older extensions. All of it needs a current context.

/// Whether shaders and instanced drawing are there.
bool canDrawInstanced();

/// glVertexAttribDivisor
void setDivisor(GLuint attribute, GLuint divisor);

/// glDrawArraysInstanced, from vertex 0
void drawInstanced(GLenum mode, GLsizei vertices, GLsizei instances);

}  // namespace line_renderer
