// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

/// What is seen, by the plainest means, and views of which ties are to be feared.
namespace plain_sight {

using laplacian_lines::LineKindSet;
using laplacian_lines::SightLine;
using laplacian_lines::TriangleMesh;
using laplacian_lines::View;

/// Contours, borders and creases.
LineKindSet edge_kinds();

struct Box {
    Eigen::Vector3d centre;
    double diagonal;
};
/// Of all finite corners of triangles.
Box box_of(const TriangleMesh& mesh);

/// From the 26 directions of the faces, edges and corners of a cube, just so, and from some in no
/// special direction.
std::vector<Eigen::Vector3d> special_directions();
/// From there, without perspective and from `distance` D.
std::vector<View> views_from(const std::vector<Eigen::Vector3d>& directions, const Box& box,
                             double distance = 2);
std::string words(const View& view);

/// Towards the eye, a unit vector.
Eigen::Vector3d towards_eye(const View& view, const Eigen::Vector3d& point);

/// Whether a ray meets a triangle farther away than `least` (T. Möller, B. Trumbore, "Fast, Minimum
/// Storage Ray-Triangle Intersection", 1997), before the eye of a perspective view.
bool is_hidden(const TriangleMesh& mesh, const View& view, const Eigen::Vector3d& point,
               double least);
/// Whether the line of sight through a point meets the mesh.
bool is_before_mesh(const TriangleMesh& mesh, const View& view, const Eigen::Vector3d& point);

/// Whether a point is within an odd number of the outlines, as the eye sees it; and how far, in
/// space, it is from them.
struct OutlinePlace {
    bool is_inside;
    double distance;
};
OutlinePlace place_in_outlines(const std::vector<SightLine>& lines, const View& view,
                               const Eigen::Vector3d& point);

}  // namespace plain_sight
