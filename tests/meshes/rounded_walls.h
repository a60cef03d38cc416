// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

/// A solid, or the half space behind one of its faces, at a point, to first order.
struct Wall {
    double distance = 0;                                ///< signed, outside > 0
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, outward

    Wall flipped() const { return {-distance, -normal}; }
};

using Solid = std::function<Wall(const Eigen::Vector3d&)>;

/// The intersection with convex edges and corners rounded: walls move inwards by the radius, and
/// the surface is at that distance from them. A ball rolls along the inside of the edges, exactly
/// for plane walls, otherwise to the order of radius² times curvature. Radius 0 leaves edges sharp.
Wall rounded_intersection(const std::vector<Wall>& walls, double radius);
/// The union, its concave edges rounded.
Wall rounded_union(const std::vector<Wall>& walls, double radius);

/// By Newton's steps along the normals.
Eigen::Vector3d onto_surface(const Solid& solid, Eigen::Vector3d p);

/// A closed mesh of a solid inside a box whose distance is exact or less: a vertex on the surface
/// for each cell of a grid that it passes, a quadrangle, cut along its shorter diagonal, for each
/// edge of the grid. Solid and gaps have to be thicker than two cells. The grid is turned, so that
/// no plane faces lie along it.
laplacian_lines::TriangleMesh surface_net(const Solid& solid, const Eigen::AlignedBox3d& box,
                                          double cell);

/// A short piece of a form's edge, sharp or rounded, in no order.
struct ArrisPiece {
    Eigen::Vector3d a, b;    ///< its ends, on the rounded surface
    double angle = 0;        ///< between the normals on both sides, degrees
    Eigen::Vector3d normal;  ///< unit, in the middle between those
    bool convex = true;

    double length() const { return (b - a).norm(); }
    Eigen::Vector3d middle() const { return (a + b) / 2; }
};

inline double total_length(const std::vector<ArrisPiece>& pieces) {
    double sum = 0;
    for (const ArrisPiece& piece : pieces)
        sum += piece.length();
    return sum;
}

}  // namespace test_meshes
