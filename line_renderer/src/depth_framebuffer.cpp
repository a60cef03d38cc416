// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth_framebuffer.h"

#include <stdexcept>

namespace line_renderer {

bool hasFramebuffers() {
    return glFeatures().framebuffers;
}

DepthFramebuffer::DepthFramebuffer(GLuint texture) {
    if (!hasFramebuffers())
        throw std::runtime_error(
            "Lines over points and wires need framebuffer objects (OpenGL 3.0): show the layer "
            "filled.");
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_before_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_before_);
    glGenFramebuffers(1, &id_);
    glBindFramebuffer(GL_FRAMEBUFFER, id_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
    unbind();
    throw std::runtime_error("The depth of the surface cannot be drawn into a texture.");
}

DepthFramebuffer::~DepthFramebuffer() {
    unbind();
}

void DepthFramebuffer::unbind() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(draw_before_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read_before_));
    glDeleteFramebuffers(1, &id_);
}

}  // namespace line_renderer
