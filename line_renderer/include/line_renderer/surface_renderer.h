// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/glew.h>

#include <QColor>
#include <QObject>
#include <map>
#include <string>

#include "line_renderer/share_group.h"
#include "line_renderer/surface_buffers.h"
#include "line_renderer/surface_depth.h"

namespace line_renderer {

/// What is seen of the faces of a mesh.
struct SurfaceAppearance {
    enum Style { AsMeshLabDrawsIt, Paper, Toon };
    static constexpr int most_tones = 8;

    Style style = AsMeshLabDrawsIt;
    QColor paper = Qt::white;
    QColor shade = QColor(150, 150, 150);  ///< where the surface turns away most
    int tones = 3;                         ///< from shade to paper, at least 2
};

/// Paints the faces of meshes over what MeshLab shows of them. Holds a program for each share
/// group. GUI thread only.
class SurfaceRenderer {
public:
    /// Paints the nearest faces into the current viewport; the current matrices must be the
    /// camera's. Nearest by MeshLab's depth buffer and by `depth`, unless that is complete, which
    /// adds nothing. `to_eye` from the mesh. Leaves OpenGL's state as it was. Returns why nothing
    /// could be painted, empty on success.
    std::string paint(const SurfaceLayer& layer, const SurfaceAppearance& appearance,
                      const Eigen::Matrix4d& to_eye, const DepthTexture& depth,
                      SurfaceBuffers& buffers);

private:
    struct Program {
        GLuint id = 0;  ///< 0: not built yet, or it could not be
        GLint paper = -1, shade = -1, tones = -1, nearer = -1, surface_depth = -1, texel = -1;
        std::string failure;
    };

    Program& programOfCurrentGroup();

    std::map<ShareGroup, Program> groups_;
    QObject receiver_;  ///< of the groups' last words; destroyed first
};

}  // namespace line_renderer
