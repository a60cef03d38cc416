// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "visibility/sight_mesh.h"

namespace laplacian_lines {

/// Where triangles that are no neighbours meet (T. Möller, "A Fast Triangle-Triangle Intersection
/// Test", 1997).
struct SurfaceContacts {
    /// A piece of the line along which two triangles run through each other.
    struct Cut {
        std::uint32_t vertices[2];
        std::uint32_t triangles[2];
    };
    /// A vertex on an edge, not an end of it.
    struct OnEdge {
        std::array<std::uint32_t, 2> edge;  ///< vertices, ascending
        std::uint32_t vertex;
    };
    std::vector<Cut> cuts;
    std::vector<OnEdge> on_edges;  ///< sorted by edges; may hold one twice
    /// By old vertex: corners of triangles that may be at the place of a cut.
    std::vector<std::uint8_t> near_cuts;
    /// Vertices nearer than a quarter of the precision, as rounding moves them. If there are any,
    /// they are all that is known: once they are one, other triangles touch.
    std::vector<std::array<std::uint32_t, 2>> at_one_place;
};

/// Two triangles run through each other if both have corners on both sides of the other's plane,
/// farther off than the precision, or if one has an edge in it with triangles on both sides; the
/// cut then has only the other, twice. Else they touch. Ends of cuts that are no corners become new
/// vertices, each on an edge. Borders nearer than a crack touch. @throws Error(Cancelled)
SurfaceContacts find_surface_contacts(SightMesh& mesh, const StageProgress& stage);

}  // namespace laplacian_lines
