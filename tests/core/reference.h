// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_style.h"
#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

/// A straightforward implementation of the paper and the public headers: double precision, all
/// pairs of vertices, one loop over all triangles. For clean meshes.
namespace reference {

using laplacian_lines::TriangleMesh;
using Vectors = std::vector<Eigen::Vector3d>;

double mean_edge(const TriangleMesh& mesh);
double diagonal(const TriangleMesh& mesh);
Vectors normals(const TriangleMesh& mesh);

/// By Gaussians of the deviation `sigma`, cut at three of it.
Vectors smoothed(const TriangleMesh& mesh, const Vectors& normals, double sigma);

/// Eq. 2 over all vertices (Belkin and others 2008), without cutoff and corrections.
Vectors laplacian(const TriangleMesh& mesh, const Vectors& normals, double kernel_size,
                  bool skip_opposite_sheet);

struct Line {
    Vectors points;  ///< mesh coordinates; of a closed line the first again at the end
    std::vector<double> gradients;
    bool closed = false;
    double length = 0, strength = 0, slope = 0;  ///< as of Polyline
};

/// Zeros of Δn·l, n·l or of the radial curvature, linear in each triangle, that are steep enough,
/// joined to lines, and those of them that are long and strong enough. `kind`: Laplacian, Contour,
/// SuggestiveContour or SuggestiveHighlight, whose slopes are not tested. Ignores Single Strokes,
/// Whole Lines, Detail and what fades or moves lines.
std::vector<Line> zero_lines(const TriangleMesh& mesh, const laplacian_lines::Field& field,
                             const laplacian_lines::View& view,
                             const laplacian_lines::LineStyle& style,
                             laplacian_lines::LineKind kind);

}  // namespace reference
