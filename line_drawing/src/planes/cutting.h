// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace line_drawing {

/// A line where a plane cuts a surface; a closed one repeats its first point.
using Cut = std::vector<Eigen::Vector3d>;

/// Cuts a mesh, which outlives this, by planes. @throws laplacian_lines::Error(InvalidMesh)
class CuttableMesh {
public:
    explicit CuttableMesh(const laplacian_lines::TriangleMesh& mesh)
        : positions_(mesh.positions), triangles_(conforming_triangles(mesh)) {}

    /// The intersection with the plane at `height` along a mesh axis, in mesh coordinates, open
    /// lines first: closed lines for closed surfaces, even if triangles share positions only, not
    /// vertices.
    std::vector<Cut> cut(int axis, double height) const;

private:
    const std::vector<Eigen::Vector3d>& positions_;
    const std::vector<laplacian_lines::Triangle> triangles_;
};

}  // namespace line_drawing
