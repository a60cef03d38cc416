// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <memory>

#include "line_renderer/depth_texture.h"
#include "line_renderer/surface_buffers.h"

namespace line_renderer {

template <class Object>
class PerShareGroup;

/// What is seen of the faces of a mesh.
struct SurfaceAppearance {
    enum Style { AsMeshLabDrawsIt, Paper, Toon };
    static constexpr int most_tones = 8;

    Style style = AsMeshLabDrawsIt;
    QColor paper = Qt::white;
    QColor shade = QColor(150, 150, 150);  ///< where the surface turns away most
    int tones = 3;                         ///< from shade to paper, at least 2
};

/// Paints the faces of meshes over what is seen of them already. Holds a program for each share
/// group. GUI thread only.
class SurfaceRenderer {
public:
    SurfaceRenderer();
    ~SurfaceRenderer();

    /// Paints the nearest faces into the current viewport; the current matrices must be the
    /// camera's. Nearest by the depth buffer and by `depth`, unless that is complete, which adds
    /// nothing. `to_eye` from the mesh. Leaves OpenGL's state as it was.
    /// @throws std::runtime_error if OpenGL cannot do it
    void paint(const SurfaceLayer& layer, const SurfaceAppearance& appearance,
               const Eigen::Matrix4d& to_eye, const DepthTexture& depth, SurfaceBuffers& buffers);

private:
    struct Program;
    std::unique_ptr<PerShareGroup<Program>> programs_;
};

}  // namespace line_renderer
