// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "visibility/box_tree.h"

namespace laplacian_lines {

/// A part of a ray: origin + t direction, 0 <= t <= length.
struct Ray {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;  ///< unit
    double length;              ///< may be infinite
};

/// Finds out whether rays meet the triangles of a mesh, by a tree of boxes. Triangles with
/// corners that are not finite are left out. Thread-safe.
class RayCaster {
public:
    /// @throws Error: InvalidMesh, Cancelled.
    RayCaster(const TriangleMesh& mesh, const StageProgress& stage);

    /// What rays near each other tell about the next one: the triangle that the last one met.
    struct Hint {
        int triangle = -1;
    };

    /// Whether any triangle meets the ray, edges and corners included. A triangle that contains the
    /// ray does not count. The hint saves time and does not change the answer.
    bool is_hit(const Ray& ray, Hint& hint) const;

    /// The unit normal of the triangle that meets the ray nearest to its middle; zero if none does.
    Eigen::Vector3d normal_near_middle(const Ray& ray) const;

    /// The sum of the solid angles of all triangles at a point, over 4π; +1 inside a closed surface
    /// that faces outwards.
    double winding_number(const Eigen::Vector3d& point) const;

private:
    struct Corners {
        Eigen::Vector3d a, b, c;
    };
    class Query;
    class MiddleQuery;

    std::vector<Corners> triangles_;
    BoxTree tree_;
};

}  // namespace laplacian_lines
