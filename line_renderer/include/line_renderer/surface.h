// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"

namespace line_renderer {

/// A corner as OpenGL reads it.
struct SurfaceVertex {
    Eigen::Vector3f position;  ///< mesh coordinates
    Eigen::Vector3f normal;    ///< of the field: smoothed, zero where a vertex was left out
};

/// The faces of a mesh, ready for OpenGL.
struct Surface {
    std::vector<SurfaceVertex> vertices;
    std::vector<laplacian_lines::Triangle> triangles;  ///< with finite corners only
};
using SurfacePointer = std::shared_ptr<const Surface>;

SurfacePointer makeSurface(const laplacian_lines::TriangleMesh& mesh,
                           const laplacian_lines::Field& field);

/// Bytes that a surface holds.
std::size_t bytesOf(const Surface& surface);

}  // namespace line_renderer
