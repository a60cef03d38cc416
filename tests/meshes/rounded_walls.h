// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace test_meshes {

/// What a solid, or the half space behind one of its faces, is at a point, to first order.
struct Wall {
    double distance = 0;                                ///< signed, outside > 0
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, outward

    Wall flipped() const { return {-distance, -normal}; }
};

/// A solid, by its wall at any point.
using Solid = std::function<Wall(const Eigen::Vector3d&)>;

/// What all of them enclose, its convex edges and corners rounded with a radius: all walls are
/// moved inwards by the radius, and the surface is what is that far from them. A ball rolls along
/// the inside of the edges, exactly for plane walls, and with an error of the order of radius²
/// times curvature for others. Radius 0 leaves edges sharp.
Wall rounded_intersection(const std::vector<Wall>& walls, double radius);
/// What any of them encloses, its concave edges rounded.
Wall rounded_union(const std::vector<Wall>& walls, double radius);

/// The point of the surface that Newton's steps along the normals lead to.
Eigen::Vector3d onto_surface(const Solid& solid, Eigen::Vector3d p);

}  // namespace test_meshes
