// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "jet.h"
#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

/// The truth at a point; signs as in the core: outward normal, S = dn (sphere: +1/R), Δn = −2/R² n
/// on a sphere.
struct SurfacePoint {
    Eigen::Vector3d position, normal, laplacian_normal;
    Eigen::Matrix3d shape_operator;  ///< symmetric, S n = 0
    /// C = ∇S: of axis i, (y, z) -> C(i, y, z). Tangential and symmetric in all places.
    std::array<Eigen::Matrix3d, 3> shape_derivative;
};

using JetVector = std::array<Jet, 3>;
/// A parametrization around the point (0, 0); r_u × r_v points outward.
using Chart = std::function<JetVector(const Jet& u, const Jet& v)>;

/// By the chart's derivatives alone: Δn is the Laplace-Beltrami operator on each component of the
/// normal.
SurfacePoint surface_point(const Chart& chart);

/// p = map(d), d a unit direction from the origin.
using DirectionMap = std::function<JetVector(const JetVector& direction)>;
SurfacePoint surface_point(const DirectionMap& map, const Eigen::Vector3d& direction);

JetVector sphere_map(const JetVector& direction, double radius);
JetVector ellipsoid_map(const JetVector& direction, const Eigen::Vector3d& half_axes);
/// Smooth bumps and grooves of about a tenth of the radius.
JetVector bumpy_map(const JetVector& direction);

struct Torus {
    double large = 1, small = 0.4;  ///< radii; the axis is z
};
SurfacePoint torus_point(const Torus& torus, double u, double v);
/// torus_point() by closed formulas.
SurfacePoint closed_form_torus_point(const Torus& torus, double u, double v);

/// Hills z = f(x, y) with bumps of about 0.1.
SurfacePoint hills_point(double x, double y);

struct AnalyticMesh {
    laplacian_lines::TriangleMesh mesh;
    std::vector<SurfacePoint> truth;
};

}  // namespace test_meshes
