// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

constexpr std::uint32_t kNoIndex = 0xffffffffu;

/// MeshLab keeps deleted vertices until the mesh is compacted. A "slot" is a position in its array,
/// a "live index" counts only vertices that are left.
bool has_deleted_vertices(const CMeshO& mesh);

/// indices[slot] = live index, or kNoIndex for deleted vertices.
std::vector<std::uint32_t> live_vertex_indices(const CMeshO& mesh);

/// Live vertices and faces in mesh coordinates (without the layer's transformation). Faces of
/// deleted vertices get kNoIndex, which the core refuses.
laplacian_lines::TriangleMesh to_triangle_mesh(const CMeshO& mesh);
/// The same, refined() for lines.
laplacian_lines::TriangleMesh to_drawn_mesh(const CMeshO& mesh);

}  // namespace meshlab_host
