// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl_functions.h"

namespace line_renderer {

/// Saves the state that drawing touches, sets what lines need (depth test without writes, blending,
/// no culling, texture unit 0) and restores it at the end of the scope, in the same current
/// context.
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
