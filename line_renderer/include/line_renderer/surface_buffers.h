// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/glew.h>

#include <QObject>
#include <map>
#include <memory>

#include "line_renderer/share_group.h"
#include "line_renderer/surface_layer.h"

namespace line_renderer {

/// The faces of surfaces in OpenGL's memory, for each share group; those of a surface that is gone
/// are freed at the group's next drawing. GUI thread only.
class SurfaceBuffers {
public:
    /// Draws all faces with their normals by whatever program is in use, within a LineGlState. The
    /// current matrices must be the camera's. Nothing if the surface is gone.
    void draw(const SurfaceLayer& layer);

private:
    struct Buffers {
        GLuint vertices = 0;
        GLuint triangles = 0;
    };
    using Group = std::map<std::weak_ptr<const Surface>, Buffers, std::owner_less<>>;

    Group& currentGroup();
    static void bind(Group& group, const SurfacePointer& surface);

    std::map<ShareGroup, Group> groups_;
    QObject receiver_;  ///< of the groups' last words; destroyed first
};

}  // namespace line_renderer
