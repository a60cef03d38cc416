// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "generators.h"

namespace test_meshes {

enum Tag : unsigned {
    kClosed = 1,        ///< a closed, consistently oriented manifold
    kBorder = 2,        ///< an oriented manifold with borders
    kNonManifold = 4,   ///< an edge with more than two triangles
    kInconsistent = 8,  ///< neighbours that disagree about the outside
    kDirty = 16,        ///< holds parts that have to be left out
    kAnalytic = 32,     ///< truth at every vertex
    kJittered = 64,     ///< irregular triangles
    kComponents = 128,  ///< more than one piece
    kSymmetric = 256,   ///< mirror symmetric in x, y and z: functions are zero at vertices
    kSharp = 512,       ///< edges at which the normal jumps
    kUnusable = 1024,   ///< has to be refused
};

struct TestMesh {
    std::string name;
    unsigned tags = 0;
    TriangleMesh mesh;
    std::vector<SurfacePoint> truth;  ///< by vertex; empty without kAnalytic

    bool has(unsigned wanted) const { return (tags & wanted) == wanted; }
};

/// All meshes, a few thousand triangles each, generated at the first call.
const std::vector<TestMesh>& all_meshes();

/// What else there is: not finite, without area, far from the origin, of thousands of pieces, ...;
/// also such as have to be refused. Not among all_meshes().
const std::vector<TestMesh>& wild_meshes();

/// Those of all_meshes() that have all wanted tags and none of the others.
std::vector<const TestMesh*> meshes_with(unsigned wanted, unsigned unwanted = 0);

/// @throws std::out_of_range
const TestMesh& mesh_named(const std::string& name);

inline std::ostream& operator<<(std::ostream& out, const TestMesh& mesh) {
    return out << mesh.name;
}
/// How GoogleTest shows the mesh that a test runs on.
inline void PrintTo(const TestMesh* mesh, std::ostream* out) {
    *out << *mesh;
}

}  // namespace test_meshes
