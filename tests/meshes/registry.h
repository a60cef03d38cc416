// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
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

/// Generated on first use: each test process asks for all names, but few meshes.
class MeshEntry {
public:
    MeshEntry(std::string name, unsigned tags, std::function<AnalyticMesh()> make)
        : name(std::move(name)), tags(tags), make_(std::move(make)) {}

    bool has(unsigned wanted) const { return (tags & wanted) == wanted; }
    const TestMesh& get() const;

    std::string name;
    unsigned tags;

private:
    std::function<AnalyticMesh()> make_;
    mutable std::shared_ptr<const TestMesh> mesh_;
};

/// A few thousand triangles each.
const std::vector<MeshEntry>& all_entries();

/// The rest, not among all_entries(): not finite, without area, far from the origin, of thousands
/// of pieces, also such as have to be refused.
const std::vector<MeshEntry>& wild_entries();

/// Those of all_entries() with all wanted tags and no unwanted one.
std::vector<const MeshEntry*> meshes_with(unsigned wanted, unsigned unwanted = 0);

/// @throws std::out_of_range
const TestMesh& mesh_named(const std::string& name);

inline std::ostream& operator<<(std::ostream& out, const TestMesh& mesh) {
    return out << mesh.name;
}
/// For GoogleTest's output.
inline void PrintTo(const MeshEntry* entry, std::ostream* out) {
    *out << entry->name;
}

}  // namespace test_meshes
