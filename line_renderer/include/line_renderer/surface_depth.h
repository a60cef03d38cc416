// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/glew.h>

#include <Eigen/Core>
#include <QObject>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "line_renderer/share_group.h"
#include "line_renderer/surface_buffers.h"

namespace line_renderer {

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
    /// must be the camera's. Draws only if something has changed since the last time. Leaves
    /// OpenGL's state as it was. Throws std::runtime_error if it cannot be done.
    DepthTexture update(const std::vector<SurfaceLayer>& layers, SurfaceBuffers& buffers);

private:
    using Viewport = std::array<GLint, 4>;
    struct Matrices {
        Eigen::Matrix4d modelview = Eigen::Matrix4d::Identity();
        Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();
    };
    struct Texture {
        GLuint id = 0;
        GLint width = 0, height = 0;
        // what it holds
        std::vector<SurfaceLayer> layers;
        Matrices camera;
        Viewport viewport{};
        bool is_copy = false;
    };

    static Matrices currentMatrices();
    Texture& currentTexture(const Viewport& viewport);
    static void enlarge(Texture& texture, GLint width, GLint height);
    static void render(GLuint texture, const std::vector<SurfaceLayer>& layers,
                       SurfaceBuffers& buffers);

    std::map<ShareGroup, Texture> groups_;
    QObject receiver_;  ///< of the groups' last words; destroyed first
};

}  // namespace line_renderer
