// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// The mesh to draw: one of a smooth surface whose triangles are too large for the kernel of a
/// drawing, as of decimated scans, is cut finer, each triangle in four, along cubic curves between
/// its vertices that are normal to their normals (A. Vlachos and others, "Curved PN Triangles",
/// 2001). Sums of the kernel then see the surface between the vertices, and features that are one
/// or two edges wide have lines. Vertices keep their numbers, new ones follow; edges that bend
/// sharply stay straight. CAD and quantised meshes, finer ones, and such as cannot be drawn are not
/// cut; noise is smoothed as before the cuts. Before that, midpoint subdivisions (all triangles cut
/// in four at the middles of their sides, once or several times) are undone, of all meshes. @throws
/// Error(Cancelled)
TriangleMesh refined(TriangleMesh mesh, const Progress& progress = {});

}  // namespace laplacian_lines
