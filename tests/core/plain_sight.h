// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <random>
#include <string>
#include <vector>

#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

/// Sight by the plainest means, and views with ties.
namespace plain_sight {

using laplacian_lines::LineKindSet;
using laplacian_lines::SightLine;
using laplacian_lines::TriangleMesh;
using laplacian_lines::View;

/// 0..1.
inline double random_unit(std::mt19937& random) {
    return double(random()) / double(std::mt19937::max());
}

/// Contours, borders and creases.
LineKindSet edge_kinds();

struct Box {
    Eigen::Vector3d centre;
    double diagonal;
};
Box box_of(const TriangleMesh& mesh);

/// Exactly towards the 26 faces, edges and corners of a cube, and a few arbitrary ones.
std::vector<Eigen::Vector3d> special_directions();
/// Orthographic and from `distance` D.
std::vector<View> views_from(const std::vector<Eigen::Vector3d>& directions, const Box& box,
                             double distance = 2);
std::string words(const View& view);

/// Unit.
Eigen::Vector3d towards_eye(const View& view, const Eigen::Vector3d& point);

/// Whether a ray meets a triangle farther than `least`, before a perspective eye (T. Möller, B.
/// Trumbore, "Fast, Minimum Storage Ray-Triangle Intersection", 1997).
bool is_hidden(const TriangleMesh& mesh, const View& view, const Eigen::Vector3d& point,
               double least);
bool is_before_mesh(const TriangleMesh& mesh, const View& view, const Eigen::Vector3d& point);

/// Whether the outlines enclose a point an odd number of times, in the picture, and its distance to
/// them in space.
struct OutlinePlace {
    bool is_inside;
    double distance;
};
OutlinePlace place_in_outlines(const std::vector<SightLine>& lines, const View& view,
                               const Eigen::Vector3d& point);

}  // namespace plain_sight
