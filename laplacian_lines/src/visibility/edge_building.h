// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "visibility/surface_contacts.h"

namespace laplacian_lines {

/// Sets edges, sides and bodies of a mesh: sides of triangles and cuts are divided at the vertices
/// on them, given in ascending order, and grouped by edge. Both triangles of a cut lie on both
/// sides of it.
void build_edges(const SurfaceContacts& contacts, VisibilityMesh& mesh);

}  // namespace laplacian_lines
