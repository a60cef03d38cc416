// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "line_renderer/surface.h"

namespace line_renderer {

template <class Object>
class PerShareGroup;

/// Faces in OpenGL's memory, by share group; freed at the group's next drawing after the surface is
/// gone. GUI thread only.
class SurfaceBuffers {
public:
    SurfaceBuffers();
    ~SurfaceBuffers();

    /// Draws all faces with normals by the program in use, with the camera's matrices current;
    /// nothing if the surface is gone. Changes OpenGL's state: for renderers, which restore it.
    void draw(const SurfaceLayer& layer);

private:
    class Group;
    std::unique_ptr<PerShareGroup<Group>> groups_;
};

}  // namespace line_renderer
