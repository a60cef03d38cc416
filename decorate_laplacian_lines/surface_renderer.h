// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/glew.h>

#include <Eigen/Core>
#include <QObject>
#include <map>

#include "share_group.h"
#include "surface.h"

/// Draws the faces of meshes, whatever MeshLab itself shows of them. Holds buffers for each share
/// group and surface; those of a surface that is gone are freed at the group's next drawing.
/// GUI thread only.
class SurfaceRenderer {
public:
    /// Puts the faces into the depth buffer, where nothing changes if MeshLab has drawn them. The
    /// current matrices must be the camera's; `layer` comes on top. Leaves OpenGL's state as it
    /// was.
    void drawDepth(const SurfacePointer& surface, const Eigen::Matrix4d& layer);

private:
    struct Buffers {
        GLuint vertices = 0;
        GLuint triangles = 0;
    };
    struct GroupObjects {
        std::map<std::weak_ptr<const Surface>, Buffers, std::owner_less<>> buffers;
    };

    GroupObjects& objectsOfCurrentGroup();
    /// Draws all faces with their normals by whatever program is in use.
    void drawFaces(const SurfacePointer& surface, const Eigen::Matrix4d& layer);

    std::map<ShareGroup, GroupObjects> groups_;
    QObject receiver_;  ///< of the groups' last words; destroyed first
};
