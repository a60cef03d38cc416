// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace benchmarks {

/// A form as programs of construction and lessons have it, of few triangles and of many.
struct Primitive {
    std::string name;
    bool is_sharp;  ///< its edges are part of the form
    std::function<laplacian_lines::TriangleMesh()> make;
};

std::vector<Primitive> primitive_meshes();

}  // namespace benchmarks
