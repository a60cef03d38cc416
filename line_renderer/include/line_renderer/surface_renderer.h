// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>

#include "line_renderer/surface.h"
#include "line_renderer/surface_depth.h"

namespace line_renderer {

template <class Object>
class PerShareGroup;
class ShaderProgram;

/// White, or in three tones from white to gray where the surface turns away.
enum class SurfaceStyle { Paper, Toon };

/// Paints the visible faces of meshes, over those that MeshLab has drawn, and the background. Keeps
/// OpenGL's state. One program each per share group. GUI thread only.
class SurfaceRenderer {
public:
    SurfaceRenderer();
    ~SurfaceRenderer();

    /// Paints the nearest faces by the depth buffer and by `depth`, which adds nothing if the
    /// buffer is complete. Needs the camera's matrices current; `to_eye` is from the mesh.
    /// @throws std::runtime_error if OpenGL cannot do it
    void paint(const SurfaceLayer& layer, SurfaceStyle style, const Eigen::Matrix4d& to_eye,
               const DepthTexture& depth, SurfaceBuffers& buffers);

    /// Paints the pixels of the current viewport that have the depth of an empty view white. Call
    /// it before drawing lines, which extend beyond outlines. Keeps depths and alpha, for snapshots
    /// without background. @throws std::runtime_error if OpenGL cannot do it
    void paint_background();

private:
    std::unique_ptr<PerShareGroup<ShaderProgram>> surface_programs_, background_programs_;
};

}  // namespace line_renderer
