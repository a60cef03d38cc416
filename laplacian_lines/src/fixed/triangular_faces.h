// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fixed/triangle_graph.h"

namespace laplacian_lines {

/// How much of the area of flat faces of several triangles, which meet at this cosine or more, is
/// in faces that are triangles themselves: as good as all where the triangles of a mesh were
/// subdivided. By some places all over the mesh, 0 to 1; 0 if there are no such faces.
double share_of_triangular_faces(const TriangleGraph& graph, float flat);

}  // namespace laplacian_lines
