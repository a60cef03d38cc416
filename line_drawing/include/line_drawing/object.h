// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"

namespace line_drawing {

/// One of the things on a drawing: a mesh in the coordinates of the drawing and its field, which
/// both have to outlive it. Without a field, one is computed whose kernel suits the drawing's
/// scale.
struct Object {
    const laplacian_lines::TriangleMesh& mesh;
    const laplacian_lines::Field* field = nullptr;
    std::string name = {};  ///< for messages
};
using Objects = std::vector<Object>;

}  // namespace line_drawing
