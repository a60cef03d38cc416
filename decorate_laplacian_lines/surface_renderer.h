// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/glew.h>

#include <Eigen/Core>
#include <QColor>
#include <QObject>
#include <map>
#include <string>

#include "share_group.h"
#include "surface.h"

/// What is seen of the faces of a mesh.
struct SurfaceAppearance {
    enum Style { AsMeshLabDrawsIt, Paper, Toon };
    static constexpr int most_tones = 8;

    Style style = AsMeshLabDrawsIt;
    QColor paper = Qt::white;
    QColor shade = QColor(150, 150, 150);  ///< where the surface turns away most
    int tones = 3;                         ///< from shade to paper, at least 2
};

/// Draws the faces of meshes, whatever MeshLab itself shows of them. Holds buffers for each share
/// group and surface; those of a surface that is gone are freed at the group's next drawing.
/// GUI thread only.
class SurfaceRenderer {
public:
    /// Puts the faces into the depth buffer, where nothing changes if MeshLab has drawn them. The
    /// current matrices must be the camera's; `layer` comes on top. Leaves OpenGL's state as it
    /// was.
    void drawDepth(const SurfacePointer& surface, const Eigen::Matrix4d& layer);

    /// Paints the faces over what MeshLab shows of them; drawDepth() has to come before. `diagonal`
    /// of the mesh in eye coordinates. Returns why nothing could be painted, empty on success.
    std::string paint(const SurfacePointer& surface, const Eigen::Matrix4d& layer,
                      const SurfaceAppearance& appearance, double diagonal);

private:
    struct Program {
        GLuint id = 0;  ///< 0: not built yet, or it could not be
        GLint paper = -1, shade = -1, tones = -1, nearer = -1;
        std::string failure;
    };
    struct Buffers {
        GLuint vertices = 0;
        GLuint triangles = 0;
    };
    struct GroupObjects {
        Program program;
        std::map<std::weak_ptr<const Surface>, Buffers, std::owner_less<>> buffers;
    };

    GroupObjects& objectsOfCurrentGroup();
    static void build(Program& program);
    /// Draws all faces with their normals by whatever program is in use.
    void drawFaces(const SurfacePointer& surface, const Eigen::Matrix4d& layer);

    std::map<ShareGroup, GroupObjects> groups_;
    QObject receiver_;  ///< of the groups' last words; destroyed first
};
