// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "line_renderer/surface.h"

namespace line_renderer {

template <class Object>
class PerShareGroup;

/// Depths 0..1 of a viewport: the window's pixel (x, y) is at (x, y) · texel.
struct DepthTexture {
    unsigned id = 0;  ///< OpenGL's name, of the current share group; 0: there is none
    Eigen::Vector2f texel = Eigen::Vector2f::Zero();
    bool is_complete = false;  ///< has everything that is in the depth buffer
};

/// The depths of the depth test of lines, a texture per share group. Keeps OpenGL's state. GUI
/// thread only.
class SurfaceDepth {
public:
    SurfaceDepth();
    ~SurfaceDepth();

    /// Call it when a redraw begins.
    void forget_depth_buffer();
    /// Whether the depth buffer is readable.
    static bool can_copy();
    /// The current viewport's depths, copied once a redraw.
    DepthTexture copy();

    /// Renders the nearest faces of all layers in the current viewport, for when the depth buffer
    /// is not readable, lacks faces, or has points or wires, which stand out. Needs the camera's
    /// matrices current. Redraws only after changes.
    /// @throws std::runtime_error if OpenGL cannot do it
    DepthTexture update(const std::vector<SurfaceLayer>& layers, SurfaceBuffers& buffers);

private:
    class Texture;
    std::unique_ptr<PerShareGroup<Texture>> textures_;
};

}  // namespace line_renderer
