// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// Symmetric 3x3 matrix S = dn: the derivative of the unit normal along the surface. S n = 0 and
/// a sphere of radius R with outward normals has the eigenvalues +1/R, +1/R, 0. Unit: 1/length.
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
    double kernel_size = 0;   ///< √h that was used (before adaptation), mesh units
    double normal_sigma = 0;  ///< standard deviation of the normal smoothing, mesh units
};

/// The view-independent field of a mesh. All vectors have one entry per vertex of the input, in
/// its order; vertices that were left out hold zeros. Always finite.
struct Field {
    std::vector<Eigen::Vector3f> normals;            ///< outward, unit, smoothed
    std::vector<Eigen::Vector3f> laplacian_normals;  ///< Δn, 1/length²; −(k1²+k2²) n + ∇(k1+k2)
    std::vector<ShapeOperator> shape_operators;      ///< S, 1/length
    std::vector<float> kernel_sizes;                 ///< √h(p), length
    /// S̄, S smoothed with the kernel, 1/length: S̄(u,u), S̄(u,v), S̄(v,v) in
    /// tangent_frame(normals[v]). Computed only when asked for, otherwise without entries.
    std::vector<Eigen::Vector3f> smooth_curvatures;
    /// C = ∇S, 1/length²: C(u,u,u), C(u,u,v), C(u,v,v), C(v,v,v) in the same frame. Symmetric in
    /// all three places. Computed together with S̄.
    std::vector<Eigen::Vector4f> curvature_derivatives;
    FieldScale scale;
    MeshReport report;

    /// Whether both S̄ and C are there.
    bool has_derivatives() const {
        return !smooth_curvatures.empty() && !curvature_derivatives.empty();
    }
};

}  // namespace laplacian_lines
