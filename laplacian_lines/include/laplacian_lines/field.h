// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// Symmetric 3x3 matrix S = dn, the derivative of the unit normal along the surface, in 1/length.
/// S n = 0; on a sphere of radius R with outward normals the eigenvalues are +1/R, +1/R, 0.
struct ShapeOperator {
    float xx = 0, yy = 0, zz = 0, yz = 0, xz = 0, xy = 0;

    Eigen::Vector3f operator*(const Eigen::Vector3f& v) const {
        return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
                xz * v.x() + yz * v.y() + zz * v.z()};
    }
    float trace() const { return xx + yy + zz; }
};

/// The scalars that go with a field.
struct FieldScale {
    double diagonal = 0;      ///< D, bounding-box diagonal of the usable mesh, mesh units
    double mean_edge = 0;     ///< ē, mesh units
    double kernel_size = 0;   ///< √h that was used, mesh units
    double normal_sigma = 0;  ///< standard deviation of the normal smoothing, mesh units
};

/// The view-independent field of a mesh: one entry per input vertex, in input order, always finite.
/// Vertices that were dropped hold zeros.
struct Field {
    std::vector<Eigen::Vector3f> normals;            ///< outward, unit, smoothed
    std::vector<Eigen::Vector3f> laplacian_normals;  ///< Δn, 1/length²; −(k1²+k2²) n + ∇(k1+k2)
    std::vector<ShapeOperator> shape_operators;      ///< S, 1/length
    /// S̄, S smoothed with the kernel, 1/length: S̄(u,u), S̄(u,v), S̄(v,v) in
    /// tangent_frame(normals[v]). Empty unless asked for.
    std::vector<Eigen::Vector3f> smooth_curvatures;
    /// C = ∇S, symmetric, 1/length²: C(u,u,u), C(u,u,v), C(u,v,v), C(v,v,v) in the same frame.
    /// Computed together with S̄.
    std::vector<Eigen::Vector4f> curvature_derivatives;
    FieldScale scale;
    MeshReport report;

    bool has_derivatives() const {
        return !smooth_curvatures.empty() && !curvature_derivatives.empty();
    }
};

}  // namespace laplacian_lines
