// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <complex>

namespace laplacian_lines {

/// C(x, x, x) of a symmetric tensor C in a plane, x = (cos θ, sin θ): a cos θ + b sin θ + p cos 3θ
/// + q sin 3θ. As complex numbers, a + ib and p + iq turn by multiplication.
struct CubicForm {
    std::complex<double> first, third;

    /// The symmetric part of the derivatives of S(u,u), S(u,v), S(v,v) along u and along v.
    static CubicForm of(const double by_u[3], const double by_v[3]) {
        const double uuu = by_u[0], uuv = (by_v[0] + 2 * by_u[1]) / 3,
                     uvv = (by_u[2] + 2 * by_v[1]) / 3, vvv = by_v[2];
        return {{0.75 * (uuu + uvv), 0.75 * (uuv + vvv)},
                {0.25 * (uuu - 3 * uvv), 0.25 * (3 * uuv - vvv)}};
    }
    /// C(u,u,u), C(u,u,v), C(u,v,v), C(v,v,v).
    Eigen::Vector4d entries() const {
        return {first.real() + third.real(), first.imag() / 3 + third.imag(),
                first.real() / 3 - third.real(), first.imag() - third.imag()};
    }

    /// In another frame, in which this one's first direction is (cos φ, sin φ) = `direction`.
    CubicForm turned(std::complex<double> direction) const {
        return {first * direction, third * direction * direction * direction};
    }
    void add(const CubicForm& other) {
        first += other.first;
        third += other.third;
    }
    void scale(double factor) {
        first *= factor;
        third *= factor;
    }
};

}  // namespace laplacian_lines
