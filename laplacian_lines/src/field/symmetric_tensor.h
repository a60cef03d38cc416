// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace laplacian_lines {

struct SymmetricTensor {
    double xx = 0, yy = 0, zz = 0, yz = 0, xz = 0, xy = 0;

    /// The symmetric part.
    static SymmetricTensor of(const Eigen::Matrix3d& a) {
        const Eigen::Matrix3d s = (a + a.transpose()) / 2;
        return {s(0, 0), s(1, 1), s(2, 2), s(1, 2), s(0, 2), s(0, 1)};
    }

    /// Adds a bᵀ + b aᵀ.
    void add_product(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        xx += 2 * a.x() * b.x();
        yy += 2 * a.y() * b.y();
        zz += 2 * a.z() * b.z();
        yz += a.y() * b.z() + a.z() * b.y();
        xz += a.x() * b.z() + a.z() * b.x();
        xy += a.x() * b.y() + a.y() * b.x();
    }
    void add(const SymmetricTensor& other, double factor) {
        xx += factor * other.xx, yy += factor * other.yy, zz += factor * other.zz;
        yz += factor * other.yz, xz += factor * other.xz, xy += factor * other.xy;
    }
    void scale(double factor) {
        xx *= factor, yy *= factor, zz *= factor;
        yz *= factor, xz *= factor, xy *= factor;
    }

    Eigen::Vector3d operator*(const Eigen::Vector3d& v) const {
        return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
                xz * v.x() + yz * v.y() + zz * v.z()};
    }
    /// Of all nine entries.
    double squaredNorm() const {
        return xx * xx + yy * yy + zz * zz + 2 * (yz * yz + xz * xz + xy * xy);
    }

    /// Restricted to the plane orthogonal to the unit vector n: P A P with P = 1 − n nᵀ.
    SymmetricTensor tangential(const Eigen::Vector3d& n) const {
        const Eigen::Vector3d column = *this * n;
        SymmetricTensor result = *this;
        result.add_product(n, n.dot(column) / 2 * n - column);
        return result;
    }
};

}  // namespace laplacian_lines
