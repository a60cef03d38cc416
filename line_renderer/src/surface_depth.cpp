// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/surface_depth.h"

#include <algorithm>
#include <stdexcept>

#include "gl_state.h"

namespace line_renderer {
namespace {

/// A framebuffer with this texture as its only content, bound as long as the object lives.
/// Framebuffers cannot be shared between contexts, so it lives for one drawing.
class DepthFramebuffer {
public:
    explicit DepthFramebuffer(GLuint texture) {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_before_);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_before_);
        glGenFramebuffers(1, &id_);
        glBindFramebuffer(GL_FRAMEBUFFER, id_);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
    }
    ~DepthFramebuffer() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(draw_before_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read_before_));
        glDeleteFramebuffers(1, &id_);
    }
    DepthFramebuffer(const DepthFramebuffer&) = delete;
    DepthFramebuffer& operator=(const DepthFramebuffer&) = delete;

    bool isComplete() const {
        return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    }

private:
    GLuint id_ = 0;
    GLint draw_before_ = 0;
    GLint read_before_ = 0;
};

std::array<GLint, 4> currentViewport() {
    std::array<GLint, 4> viewport;
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    return viewport;
}

}  // namespace

void SurfaceDepth::forgetDepthBuffer() {
    for (auto& group : groups_)
        group.second.is_copy = false;
}

bool SurfaceDepth::canCopy() {
    GLint framebuffer = 0, samples = 0;
    glGetIntegerv(GL_SAMPLES, &samples);
    if (GLEW_VERSION_3_0 || GLEW_ARB_framebuffer_object)
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
    return framebuffer == 0 || samples == 0;
}

DepthTexture SurfaceDepth::copy() {
    const Viewport viewport = currentViewport();
    Texture& texture = currentTexture(viewport);
    if (!texture.is_copy || texture.viewport != viewport) {
        const LineGlState state;
        glBindTexture(GL_TEXTURE_2D, texture.id);
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, viewport[0], viewport[1], viewport[0], viewport[1],
                            viewport[2], viewport[3]);
        texture.layers.clear();
        texture.viewport = viewport;
        texture.is_copy = true;
    }
    return {texture.id, {1 / float(texture.width), 1 / float(texture.height)}, true};
}

SurfaceDepth::Matrices SurfaceDepth::currentMatrices() {
    Matrices matrices;
    glGetDoublev(GL_MODELVIEW_MATRIX, matrices.modelview.data());
    glGetDoublev(GL_PROJECTION_MATRIX, matrices.projection.data());
    return matrices;
}

DepthTexture SurfaceDepth::update(const std::vector<SurfaceLayer>& layers,
                                  SurfaceBuffers& buffers) {
    if (!GLEW_VERSION_3_0 && !GLEW_ARB_framebuffer_object)
        throw std::runtime_error(
            "Lines over points and wires need framebuffer objects (OpenGL 3.0): show the layer "
            "filled.");
    const Viewport viewport = currentViewport();
    Texture& texture = currentTexture(viewport);
    const Matrices camera = currentMatrices();
    const bool is_current = !texture.is_copy && texture.layers == layers &&
                            texture.viewport == viewport &&
                            texture.camera.modelview == camera.modelview &&
                            texture.camera.projection == camera.projection;
    if (!is_current) {
        texture.layers.clear();
        texture.is_copy = false;
        render(texture.id, layers, buffers);
        texture.layers = layers;
        texture.camera = camera;
        texture.viewport = viewport;
    }
    return {texture.id, {1 / float(texture.width), 1 / float(texture.height)}, false};
}

SurfaceDepth::Texture& SurfaceDepth::currentTexture(const Viewport& viewport) {
    const ShareGroup group = currentShareGroup();
    const auto [place, is_new] = groups_.try_emplace(group);
    if (is_new) whenGone(group, &receiver_, [this, group] { groups_.erase(group); });
    enlarge(place->second, viewport[0] + viewport[2], viewport[1] + viewport[3]);
    return place->second;
}

void SurfaceDepth::enlarge(Texture& texture, GLint width, GLint height) {
    if (texture.id && width <= texture.width && height <= texture.height) return;
    texture.width = std::max(width, texture.width);
    texture.height = std::max(height, texture.height);
    texture.layers.clear();
    texture.is_copy = false;
    const LineGlState state;
    if (!texture.id) glGenTextures(1, &texture.id);
    glBindTexture(GL_TEXTURE_2D, texture.id);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, texture.width, texture.height, 0,
                 GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void SurfaceDepth::render(GLuint texture, const std::vector<SurfaceLayer>& layers,
                          SurfaceBuffers& buffers) {
    const LineGlState state;
    const DepthFramebuffer framebuffer(texture);
    if (!framebuffer.isComplete())
        throw std::runtime_error("The depth of the surface cannot be drawn into a texture.");
    // the fixed pipeline, as in MeshLab's own drawing and in ours, so that depths are the same
    glUseProgram(0);
    for (GLenum feature : {GL_BLEND, GL_TEXTURE_2D, GL_LIGHTING, GL_SCISSOR_TEST})
        glDisable(feature);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glClearDepth(1);
    glClear(GL_DEPTH_BUFFER_BIT);
    for (const SurfaceLayer& layer : layers)
        buffers.draw(layer);
}

}  // namespace line_renderer
