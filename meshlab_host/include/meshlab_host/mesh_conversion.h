// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// Marks an index that leads nowhere.
constexpr std::uint32_t no_index = 0xffffffffu;

/// MeshLab keeps deleted vertices in its vertex array until the mesh is compacted. A "slot" is a
/// position in that array, a "live index" counts only the vertices that are left.
bool hasDeletedVertices(const CMeshO& mesh);

/// indices[slot] = live index, or no_index for deleted vertices.
std::vector<std::uint32_t> liveVertexIndices(const CMeshO& mesh);

/// The live vertices and faces of a mesh in their order, in mesh coordinates (the layer's
/// transformation is not applied). Faces of deleted vertices come out with no_index as corner,
/// which the core refuses as an invalid mesh.
laplacian_lines::TriangleMesh toTriangleMesh(const CMeshO& mesh);

}  // namespace meshlab_host
