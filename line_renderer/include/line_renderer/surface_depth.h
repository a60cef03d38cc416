// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "line_renderer/depth_texture.h"
#include "line_renderer/surface_buffers.h"

namespace line_renderer {

template <class Object>
class PerShareGroup;

/// The depths that lines are compared with, for shaders to read. One texture for each share group.
/// Leaves OpenGL's state as it was. GUI thread only.
class SurfaceDepth {
public:
    SurfaceDepth();
    ~SurfaceDepth();

    /// To be called when a redraw begins.
    void forgetDepthBuffer();
    /// Whether the depth buffer can be read at all.
    static bool canCopy();
    /// A copy of the current viewport of the depth buffer, made once a redraw.
    DepthTexture copy();

    /// The nearest faces of all layers in the current viewport, apart from the depth buffer, where
    /// points and wires stick out of them, or stand without faces. The current matrices must be the
    /// camera's. Draws only if something has changed since the last time.
    /// @throws std::runtime_error if OpenGL cannot do it
    DepthTexture update(const std::vector<SurfaceLayer>& layers, SurfaceBuffers& buffers);

private:
    class Texture;
    std::unique_ptr<PerShareGroup<Texture>> textures_;
};

}  // namespace line_renderer
