// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/triangle_mesh.h"

namespace line_drawing {

/// A mesh in the coordinates of the drawing and its field, which outlive it. Without a field, one
/// is computed whose kernel suits the scale.
struct Object {
    const laplacian_lines::TriangleMesh& mesh;
    const laplacian_lines::Field* field = nullptr;
    std::string name = {};  ///< for messages
    /// Built from the field, or without one, from a field with the kernel `extractor_kernel`, for
    /// drawings that have to be fast. May be null.
    const laplacian_lines::LineExtractor* extractor = nullptr;
    double extractor_kernel = 0;  ///< √h, mesh units
};
using Objects = std::vector<Object>;

/// Of the triangles' vertices that are finite, and that the mesh had before it was refined.
Eigen::AlignedBox3d bounds_of(const laplacian_lines::TriangleMesh& mesh);
Eigen::AlignedBox3d bounds_of(const Objects& objects);

}  // namespace line_drawing
