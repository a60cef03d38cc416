// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl_functions.h"

namespace line_renderer {

/// A framebuffer with only a depth texture, bound while the object lives, then replaced by those
/// bound before. Contexts cannot share framebuffers, so it lives for one drawing.
class DepthFramebuffer {
public:
    /// @throws std::runtime_error if there are no framebuffer objects, or not for this texture
    explicit DepthFramebuffer(GLuint texture);
    ~DepthFramebuffer();
    DepthFramebuffer(const DepthFramebuffer&) = delete;
    DepthFramebuffer& operator=(const DepthFramebuffer&) = delete;

private:
    void unbind();

    GLuint id_ = 0;
    GLint draw_before_ = 0;
    GLint read_before_ = 0;
};

bool hasFramebuffers();

}  // namespace line_renderer
