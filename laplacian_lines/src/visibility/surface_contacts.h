// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/box_tree.h"
#include "mesh/sides_by_edge.h"
#include "visibility/visibility_mesh.h"

namespace laplacian_lines {

/// Where triangles that are no neighbours meet (T. Möller, "A Fast Triangle-Triangle Intersection
/// Test", 1997).
struct SurfaceContacts {
    /// A segment along which two triangles intersect.
    struct Cut {
        Edge vertices;
        std::uint32_t triangles[2];
    };
    /// A vertex on an edge, not an end of it.
    struct OnEdge {
        Edge edge;
        std::uint32_t vertex;

        bool operator<(const OnEdge& other) const {
            return edge != other.edge ? edge < other.edge : vertex < other.vertex;
        }
    };
    std::vector<Cut> cuts;
    std::vector<OnEdge> on_edges;  ///< in no order; may hold one twice
    BoxTree<3> triangles;          ///< the mesh's, local
};

/// Two triangles intersect if both have corners on both sides of the other's plane, farther off
/// than the precision, or if one has an edge in it with triangles on both sides; the cut then has
/// only the other, twice. Else they touch. Ends of cuts that are no corners become new vertices,
/// each on an edge. Also sets mesh.along_curve. @throws Error(Cancelled)
SurfaceContacts find_surface_contacts(VisibilityMesh& mesh, const StageProgress& stage);

/// Sets edges, sides and bodies of a mesh: sides of triangles and cuts are divided at the vertices
/// on them, given in ascending order, and grouped by edge. Both triangles of a cut lie on both
/// sides of it.
void build_edges(const SurfaceContacts& contacts, VisibilityMesh& mesh);

}  // namespace laplacian_lines
