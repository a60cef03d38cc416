// SPDX-License-Identifier: GPL-3.0-or-later
// Depths of the surfaces that may hide lines, as a texture: a copy of MeshLab's depth buffer where
// that holds these surfaces alone, else drawn by ourselves, once as long as nothing changes.
#include "line_renderer/surface_depth.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "gl_state.h"
#include "per_share_group.h"

namespace line_renderer {
namespace {

using Viewport = std::array<GLint, 4>;

/// All that the depths of some layers depend on.
struct DrawnScene {
    std::vector<SurfaceLayer> layers;
    Eigen::Matrix4d modelview;
    Eigen::Matrix4d projection;
    Viewport viewport;

    bool operator==(const DrawnScene& other) const {
        return layers == other.layers && modelview == other.modelview &&
               projection == other.projection && viewport == other.viewport;
    }
};

DrawnScene current_scene(const std::vector<SurfaceLayer>& layers) {
    DrawnScene scene;
    scene.layers = layers;
    glGetDoublev(GL_MODELVIEW_MATRIX, scene.modelview.data());
    glGetDoublev(GL_PROJECTION_MATRIX, scene.projection.data());
    scene.viewport = current_viewport();
    return scene;
}

/// A framebuffer with only a depth texture, bound while the object lives, then replaced by those
/// bound before. Contexts cannot share framebuffers, so it lives for one drawing.
class DepthFramebuffer {
public:
    /// @throws std::runtime_error if there are no framebuffer objects, or not for this texture
    explicit DepthFramebuffer(GLuint texture) {
        if (!gl_features().framebuffers)
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
    ~DepthFramebuffer() { unbind(); }
    DepthFramebuffer(const DepthFramebuffer&) = delete;
    DepthFramebuffer& operator=(const DepthFramebuffer&) = delete;

private:
    void unbind() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(draw_before_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read_before_));
        glDeleteFramebuffers(1, &id_);
    }

    GLuint id_ = 0;
    GLint draw_before_ = 0, read_before_ = 0;
};

/// By the fixed pipeline, as MeshLab draws, for equal depths.
void render(GLuint texture, const std::vector<SurfaceLayer>& layers, SurfaceBuffers& buffers) {
    const GlState state;
    const DepthFramebuffer framebuffer(texture);
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

}  // namespace

class SurfaceDepth::Texture {
public:
    void forget_copy() { copied_.reset(); }

    void copy(const Viewport& viewport) {
        enlarge(viewport);
        if (copied_ == viewport) return;
        const GlState state;
        glBindTexture(GL_TEXTURE_2D, id_);
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, viewport[0], viewport[1], viewport[0], viewport[1],
                            viewport[2], viewport[3]);
        rendered_.reset();
        copied_ = viewport;
    }

    void update(const DrawnScene& scene, SurfaceBuffers& buffers) {
        enlarge(scene.viewport);
        if (rendered_ == scene) return;
        forget();
        render(id_, scene.layers, buffers);
        rendered_ = scene;
    }

    DepthTexture content() const {
        return {id_, {1 / float(width_), 1 / float(height_)}, copied_.has_value()};
    }

private:
    void forget() {
        copied_.reset();
        rendered_.reset();
    }

    void enlarge(const Viewport& viewport) {
        const GLint width = viewport[0] + viewport[2], height = viewport[1] + viewport[3];
        if (id_ && width <= width_ && height <= height_) return;
        width_ = std::max(width, width_);
        height_ = std::max(height, height_);
        forget();
        const GlState state;
        if (!id_) glGenTextures(1, &id_);
        glBindTexture(GL_TEXTURE_2D, id_);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, width_, height_, 0, GL_DEPTH_COMPONENT,
                     GL_UNSIGNED_INT, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }

    GLuint id_ = 0;
    GLint width_ = 0, height_ = 0;
    // Content: a copy of this part of the depth buffer, these layers, or nothing.
    std::optional<Viewport> copied_;
    std::optional<DrawnScene> rendered_;
};

SurfaceDepth::SurfaceDepth() : textures_(std::make_unique<PerShareGroup<Texture>>()) {}

SurfaceDepth::~SurfaceDepth() = default;

void SurfaceDepth::forget_depth_buffer() {
    textures_->for_each([](Texture& texture) { texture.forget_copy(); });
}

bool SurfaceDepth::can_copy() {
    GLint framebuffer = 0, samples = 0;
    glGetIntegerv(GL_SAMPLES, &samples);
    if (gl_features().framebuffers) glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
    return framebuffer == 0 || samples == 0;
}

DepthTexture SurfaceDepth::copy() {
    Texture& texture = textures_->current();
    texture.copy(current_viewport());
    return texture.content();
}

DepthTexture SurfaceDepth::update(const std::vector<SurfaceLayer>& layers,
                                  SurfaceBuffers& buffers) {
    Texture& texture = textures_->current();
    texture.update(current_scene(layers), buffers);
    return texture.content();
}

}  // namespace line_renderer
