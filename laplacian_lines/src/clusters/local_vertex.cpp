// SPDX-License-Identifier: GPL-3.0-or-later
// The bounds of n·(e − w p) over a cluster are those of n, in a box along the axes of its
// covariance, and of n·(p − c), c the centre.
#include "clusters/local_vertex.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace laplacian_lines {
namespace {

/// A box with the axes of the vectors' covariance: about the smallest one.
struct VectorBox {
    Eigen::Vector3d centre;
    Eigen::Matrix3d half_axes;  ///< columns
};
VectorBox enclose_normals(const std::vector<LocalVertex>& values) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const LocalVertex& v : values) {
        sum += v.normal;
        squares += v.normal * v.normal.transpose();
    }
    const double n = double(values.size());
    const Eigen::Matrix3d covariance = squares / n - sum * sum.transpose() / (n * n);
    const Eigen::Matrix3d axes =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
    Eigen::Vector3d low = axes.transpose() * values[0].normal, high = low;
    for (const LocalVertex& v : values) {
        low = low.cwiseMin(axes.transpose() * v.normal);
        high = high.cwiseMax(axes.transpose() * v.normal);
    }
    return {axes * (low + high) / 2, axes * ((high - low) / 2).asDiagonal()};
}

Eigen::Vector3d centre_of(const std::vector<LocalVertex>& values) {
    Eigen::AlignedBox3d box;
    for (const LocalVertex& v : values)
        box.extend(v.position);
    return box.center();
}

}  // namespace

VertexRecord make_record(const LocalVertex& v) {
    const ShapeOperator& s = v.shape_operator;
    const Eigen::Vector3f n = v.normal.cast<float>();
    return {{float(v.position.x()), float(v.position.y()), float(v.position.z()), 0},
            {{s.xx, s.xy, s.xz, n.x()}, {s.xy, s.yy, s.yz, n.y()}, {s.xz, s.yz, s.zz, n.z()}}};
}

void write_facing_bounds(const std::vector<LocalVertex>& values, FacingBounds& bounds,
                         std::size_t place) {
    const Eigen::Vector3d centre = centre_of(values);
    const VectorBox normals = enclose_normals(values);
    double low = std::numeric_limits<double>::max(), high = -low;
    for (const LocalVertex& v : values) {
        const double height = v.normal.dot(v.position - centre);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    for (int k = 0; k < 3; ++k) {
        bounds.centre[k][place] = float(centre[k]);
        bounds.normal[k][place] = float(normals.centre[k]);
        for (int axis = 0; axis < 3; ++axis)
            bounds.axes[axis][k][place] = float(normals.half_axes(k, axis));
    }
    bounds.height[place] = float((low + high) / 2);
    bounds.height_range[place] = float((high - low) / 2);
}

}  // namespace laplacian_lines
