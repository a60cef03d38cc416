// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "line_renderer/depth_texture.h"
#include "line_renderer/surface_buffers.h"

namespace line_renderer {

template <class Object>
class PerShareGroup;

/// The depths that lines are compared with, a texture per share group. Keeps OpenGL's state. GUI
/// thread only.
class SurfaceDepth {
public:
    SurfaceDepth();
    ~SurfaceDepth();

    /// Call it when a redraw begins.
    void forgetDepthBuffer();
    /// Whether the depth buffer is readable.
    static bool canCopy();
    /// The current viewport's depths, copied once a redraw.
    DepthTexture copy();

    /// The nearest faces of all layers in the current viewport, for where points and wires stick
    /// out of them, or have no faces. Needs the camera's matrices current. Redraws only after
    /// changes. @throws std::runtime_error if OpenGL cannot do it
    DepthTexture update(const std::vector<SurfaceLayer>& layers, SurfaceBuffers& buffers);

private:
    class Texture;
    std::unique_ptr<PerShareGroup<Texture>> textures_;
};

}  // namespace line_renderer
