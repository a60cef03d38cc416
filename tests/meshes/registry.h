// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generators.h"

namespace test_meshes {

struct TestMesh {
    std::string name;
    TriangleMesh mesh;
    bool is_closed = false;           ///< a closed, consistently oriented manifold
    std::vector<SurfacePoint> truth;  ///< by vertex, if it samples a smooth surface
};

/// Of 20,000 triangles at most.
std::vector<std::string> mesh_names();

/// Generated on first use: each test process asks for all names, but few meshes.
/// @throws std::out_of_range
const TestMesh& mesh_named(const std::string& name);

}  // namespace test_meshes
