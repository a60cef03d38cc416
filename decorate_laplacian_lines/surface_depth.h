// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/glew.h>

#include <Eigen/Core>
#include <QObject>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "meshlab_host/camera.h"
#include "share_group.h"
#include "surface_buffers.h"

/// Depths in 0..1 of a viewport's pixels: pixel (x, y) of the window is at (x, y) · texel.
struct DepthTexture {
    GLuint id = 0;  ///< 0: there is none
    Eigen::Vector2f texel = Eigen::Vector2f::Zero();
    bool is_complete = false;  ///< holds all that is in the depth buffer too
};

/// The depths that lines are compared with, for shaders to read. One texture for each share group.
/// GUI thread only.
class SurfaceDepth {
public:
    /// To be called when a redraw begins.
    void forgetDepthBuffer();
    /// Whether the depth buffer can be read at all.
    static bool canCopy();
    /// A copy of the current viewport of the depth buffer, made once a redraw.
    DepthTexture copy();

    /// The nearest faces of all layers in the current viewport, apart from the depth buffer, where
    /// MeshLab's points and wires stick out of them, or stand without faces. The current matrices
    /// must be those of `camera`. Draws only if something has changed since the last time. Leaves
    /// OpenGL's state as it was. Throws std::runtime_error if it cannot be done.
    DepthTexture update(const std::vector<SurfaceLayer>& layers,
                        const meshlab_host::CameraMatrices& camera, SurfaceBuffers& buffers);

private:
    using Viewport = std::array<GLint, 4>;
    struct Texture {
        GLuint id = 0;
        GLint width = 0, height = 0;
        // what it holds
        std::vector<SurfaceLayer> layers;
        meshlab_host::CameraMatrices camera;
        Viewport viewport{};
        bool is_copy = false;
    };

    Texture& currentTexture(const Viewport& viewport);
    static void enlarge(Texture& texture, GLint width, GLint height);
    static void render(GLuint texture, const std::vector<SurfaceLayer>& layers,
                       SurfaceBuffers& buffers);

    std::map<ShareGroup, Texture> groups_;
    QObject receiver_;  ///< of the groups' last words; destroyed first
};
