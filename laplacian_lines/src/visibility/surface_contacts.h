// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "visibility/sight_mesh.h"

namespace laplacian_lines {

/// Where triangles that are no neighbours meet.
struct SurfaceContacts {
    /// A piece of the line along which two triangles run through each other.
    struct Cut {
        std::uint32_t vertices[2];
        std::uint32_t triangles[2];
    };
    /// A vertex on an edge that it is not an end of.
    struct OnEdge {
        std::array<std::uint32_t, 2> edge;  ///< vertices, ascending
        std::uint32_t vertex;
    };
    std::vector<Cut> cuts;
    std::vector<OnEdge> on_edges;  ///< sorted by edges; may hold one twice
    /// By vertex, but those that were added: corners of triangles that may be at the place of a
    /// cut.
    std::vector<std::uint8_t> near_cuts;
};

/// Two triangles run through each other if both have corners on both sides of the other's plane,
/// farther from it than the precision, or one an edge in it with triangles on both sides, of which
/// the cut then has only the other, twice; else they only touch. Ends of cuts that are no corners
/// become new vertices behind the others, each on an edge. Borders that are nearer to each other
/// than a crack touch. @throws Error(Cancelled)
SurfaceContacts find_surface_contacts(SightMesh& mesh, const StageProgress& stage);

/// In D: gaps along borders so narrow are cracks of the mesh, which no paper shows.
constexpr double kCrack = 1e-5;

}  // namespace laplacian_lines
