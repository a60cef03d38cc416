// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <complex>

namespace laplacian_lines {

/// C(x, x, x) of a symmetric tensor C in a plane, x = (cos θ, sin θ): a cos θ + b sin θ + p cos 3θ
/// + q sin 3θ. As complex numbers, a + ib and p + iq turn by multiplication.
struct CubicForm {
    std::complex<double> first, third;

    /// From C(u,u,u), C(u,u,v), C(u,v,v), C(v,v,v) in the frame (u, v).
    static CubicForm of(double uuu, double uuv, double uvv, double vvv) {
        return {{0.75 * (uuu + uvv), 0.75 * (uuv + vvv)},
                {0.25 * (uuu - 3 * uvv), 0.25 * (3 * uuv - vvv)}};
    }
    Eigen::Vector4d entries() const {
        return {first.real() + third.real(), first.imag() / 3 + third.imag(),
                first.real() / 3 - third.real(), first.imag() - third.imag()};
    }

    /// In another frame, in which this one's first direction is (cos φ, sin φ) = `direction`.
    CubicForm turned(std::complex<double> direction) const {
        return {first * direction, third * direction * direction * direction};
    }
    void add(const CubicForm& other, double factor) {
        first += factor * other.first;
        third += factor * other.third;
    }
    void scale(double factor) {
        first *= factor;
        third *= factor;
    }
};

}  // namespace laplacian_lines
