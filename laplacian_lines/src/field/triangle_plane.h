// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/triangle_sizes.h"

namespace laplacian_lines {

/// A triangle's plane, with the orthonormal n, t along the edge opposite corner 0, and b. Without
/// an area n and b are not finite.
struct TrianglePlane {
    TrianglePlane(const std::vector<Eigen::Vector3d>& p, const Triangle& v)
        : edges{p[v[2]] - p[v[1]], p[v[0]] - p[v[2]], p[v[1]] - p[v[0]]} {
        const Eigen::Vector3d area = area_vector(p, v);
        twice_area = area.norm();
        n = area / twice_area;
        t = edges[0] / edges[0].norm();
        b = n.cross(t);
    }

    Eigen::Vector3d edges[3];  ///< by opposite corner
    Eigen::Vector3d n, t, b;
    double twice_area;
};

/// x, orthogonal to the unit vector n, turned by the smallest rotation of n to the unit vector m
/// (Rodrigues); not finite if they are opposite. The result is orthogonal to m.
inline Eigen::Vector3d turned(const Eigen::Vector3d& x, const Eigen::Vector3d& n,
                              const Eigen::Vector3d& m) {
    return x - (n + m) / (1 + n.dot(m)) * x.dot(m);
}

}  // namespace laplacian_lines
