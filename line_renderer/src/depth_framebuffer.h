// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl_functions.h"

namespace line_renderer {

/// A framebuffer with a depth texture as its only content, bound as long as the object lives; those
/// bound before come back. Framebuffers cannot be shared between contexts, so it lives for one
/// drawing.
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

/// Whether the current context has framebuffer objects.
bool hasFramebuffers();

}  // namespace line_renderer
