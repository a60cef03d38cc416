// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl_functions.h"

namespace line_renderer {

/// Saves the OpenGL state that drawing lines and surfaces touches, sets what lines need (depth test
/// without depth writes, blending, no culling, texture unit 0) and restores all of it when it goes
/// out of scope. The context must be the same and current at both ends.
class GlState {
public:
    GlState();
    ~GlState();
    GlState(const GlState&) = delete;
    GlState& operator=(const GlState&) = delete;

private:
    GLint program_ = 0;
    GLint array_buffer_ = 0;
    GLint element_buffer_ = 0;
    GLint vertex_array_ = 0;
    GLint texture_unit_ = 0;
    GLint texture_ = 0;  ///< of unit 0
    bool has_vertex_arrays_;
};

}  // namespace line_renderer
