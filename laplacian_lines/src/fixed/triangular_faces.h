// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fixed/triangle_graph.h"

namespace laplacian_lines {

/// Flat faces that are triangles themselves, of several triangles of the mesh: as good as all flat
/// faces where the triangles of a scan were subdivided.
struct TriangularFaces {
    double share = 0;  ///< of the area of flat faces of several triangles, 0 to 1
    double parts = 1;  ///< triangles of the mesh in one of them, on the mean
};

/// Flat is what meets at this cosine or more. By some places all over the mesh.
TriangularFaces find_triangular_faces(const TriangleGraph& graph, float flat);

}  // namespace laplacian_lines
