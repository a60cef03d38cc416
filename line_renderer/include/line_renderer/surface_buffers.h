// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "line_renderer/surface.h"

namespace line_renderer {

template <class Object>
class PerShareGroup;

/// The faces of surfaces in OpenGL's memory, for each share group; those of a surface that is gone
/// are freed at the group's next drawing. GUI thread only.
class SurfaceBuffers {
public:
    SurfaceBuffers();
    ~SurfaceBuffers();

    /// Draws all faces with their normals by whatever program is in use. The current matrices must
    /// be the camera's. Changes OpenGL's state: for the renderers, which restore it. Nothing if the
    /// surface is gone.
    void draw(const SurfaceLayer& layer);

private:
    class Group;
    std::unique_ptr<PerShareGroup<Group>> groups_;
};

}  // namespace line_renderer
