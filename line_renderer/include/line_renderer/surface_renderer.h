// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>

#include "line_renderer/depth_texture.h"
#include "line_renderer/surface_buffers.h"

namespace line_renderer {

template <class Object>
class PerShareGroup;

/// White, or in three tones from white to gray where the surface turns away.
enum class SurfaceStyle { Paper, Toon };

/// Paints faces of meshes over what is seen of them already. One program per share group. GUI
/// thread only.
class SurfaceRenderer {
public:
    SurfaceRenderer();
    ~SurfaceRenderer();

    /// Paints the nearest faces by the depth buffer and by `depth`, which adds nothing if the
    /// buffer is complete. Needs the camera's matrices current; `to_eye` is from the mesh. Keeps
    /// OpenGL's state. @throws std::runtime_error if OpenGL cannot do it
    void paint(const SurfaceLayer& layer, SurfaceStyle style, const Eigen::Matrix4d& to_eye,
               const DepthTexture& depth, SurfaceBuffers& buffers);

private:
    struct Program;
    std::unique_ptr<PerShareGroup<Program>> programs_;
};

}  // namespace line_renderer
