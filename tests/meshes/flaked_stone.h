// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "rounded_walls.h"

namespace test_meshes {

struct StoneShape {
    unsigned seed = 1;
    double edge_radius = 0.01;  ///< of its arrises, in D
    int scars = 40;
    double ripple_angle = 5;  ///< the most by which ripples turn a surface, degrees
    Eigen::Vector3d half_axes = {1, 0.7, 0.45};  ///< of the body; the first one is the largest
};

/// An ellipsoid with shallow scars of large spheres, and arrises where these meet. Every third scar
/// is conchoidal, with ripples around its point of percussion. Rays from the origin meet the
/// surface once, so meshes of any resolution sample the same surface.
class FlakedStone {
public:
    explicit FlakedStone(const StoneShape& shape);

    double diagonal() const { return diagonal_; }        ///< D
    double edge_radius() const { return edge_radius_; }  ///< in the units of the body
    /// With rounded arrises.
    Wall wall(const Eigen::Vector3d& p) const;
    /// In a unit direction from the origin.
    Eigen::Vector3d surface(const Eigen::Vector3d& direction) const;

    /// Without rounding.
    Eigen::Vector3d sharp_surface(const Eigen::Vector3d& direction) const;
    /// 0 is the body, others are scars.
    int face(const Eigen::Vector3d& direction) const;
    /// As if it were the only face.
    Wall face_wall(int face, const Eigen::Vector3d& p) const;

    /// 20 · 4^level triangles: an icosphere with vertices jittered by up to `jitter` edges.
    laplacian_lines::TriangleMesh mesh(int level, double jitter = 0.15) const;

private:
    struct Scar {
        Eigen::Vector3d centre;
        double radius = 1;
        Eigen::Vector3d percussion;
        double ripple = 0;  ///< height of the ripples
    };
    static Wall scar_wall(const Scar& scar, const Eigen::Vector3d& p);
    Wall body_wall(const Eigen::Vector3d& p) const;
    Scar random_scar(std::mt19937& random, const Eigen::Vector3d& direction) const;
    std::vector<Wall> walls(const Eigen::Vector3d& p) const;
    int outermost_face(const Eigen::Vector3d& p) const;

    Eigen::Vector3d half_axes_;
    std::vector<Scar> scars_;
    double diagonal_ = 0, edge_radius_ = 0;
};

/// Borders between the faces that rays through an icosphere of 20 · 4^level triangles meet, of at
/// least `least_angle` degrees.
std::vector<ArrisPiece> find_arrises(const FlakedStone& stone, double least_angle, int level = 5);

}  // namespace test_meshes
