// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace benchmarks {

/// A mesh as programs hold it for drawing, in floats: what the plain ways to draw lines read.
struct PlainMesh {
    explicit PlainMesh(const laplacian_lines::TriangleMesh& mesh) : triangles(mesh.triangles) {
        positions.reserve(mesh.positions.size());
        for (const Eigen::Vector3d& p : mesh.positions)
            positions.push_back(p.cast<float>());
    }

    std::vector<Eigen::Vector3f> positions;
    std::vector<laplacian_lines::Triangle> triangles;
};

}  // namespace benchmarks
