// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

namespace test_meshes {

/// Taylor polynomial Σ c(i, j) u^i v^j, i + j <= 3, around (0, 0): exact derivatives. Deriving
/// costs one degree.
class Jet {
public:
    static constexpr int kDegree = 3;

    Jet(double constant = 0) { c_[0][0] = constant; }
    static Jet u() { return variable(1, 0); }
    static Jet v() { return variable(0, 1); }

    double value() const { return c_[0][0]; }

    Jet derivative_u() const {
        Jet d;
        for (int i = 1; i <= kDegree; ++i)
            for (int j = 0; i + j <= kDegree; ++j)
                d.c_[i - 1][j] = i * c_[i][j];
        return d;
    }
    Jet derivative_v() const {
        Jet d;
        for (int j = 1; j <= kDegree; ++j)
            for (int i = 0; i + j <= kDegree; ++i)
                d.c_[i][j - 1] = j * c_[i][j];
        return d;
    }

    Jet operator-() const { return Jet() - *this; }
    friend Jet operator+(Jet a, const Jet& b) {
        for_each_term([&](int i, int j) { a.c_[i][j] += b.c_[i][j]; });
        return a;
    }
    friend Jet operator-(Jet a, const Jet& b) {
        for_each_term([&](int i, int j) { a.c_[i][j] -= b.c_[i][j]; });
        return a;
    }
    friend Jet operator*(const Jet& a, const Jet& b) {
        Jet product;
        for_each_term([&](int i, int j) {
            for (int k = 0; i + j + k <= kDegree; ++k)
                for (int l = 0; i + j + k + l <= kDegree; ++l)
                    product.c_[i + k][j + l] += a.c_[i][j] * b.c_[k][l];
        });
        return product;
    }
    friend Jet operator/(const Jet& a, const Jet& b) { return a * reciprocal(b); }

    friend Jet reciprocal(const Jet& a) {
        const double r = 1 / a.value();
        return a.compose({r, -r * r, 2 * r * r * r, -6 * r * r * r * r});
    }
    friend Jet sqrt(const Jet& a) {
        const double r = std::sqrt(a.value()), x = a.value();
        return a.compose({r, 0.5 / r, -0.25 / (r * x), 0.375 / (r * x * x)});
    }
    friend Jet sin(const Jet& a) {
        const double s = std::sin(a.value()), c = std::cos(a.value());
        return a.compose({s, c, -s, -c});
    }
    friend Jet cos(const Jet& a) {
        const double s = std::sin(a.value()), c = std::cos(a.value());
        return a.compose({c, -s, -c, s});
    }

private:
    static Jet variable(int i, int j) {
        Jet x;
        x.c_[i][j] = 1;
        return x;
    }

    template <class Visit>
    static void for_each_term(Visit visit) {
        for (int i = 0; i <= kDegree; ++i)
            for (int j = 0; i + j <= kDegree; ++j)
                visit(i, j);
    }

    /// f(a) from f and its derivatives at a's value.
    Jet compose(const std::array<double, kDegree + 1>& f) const {
        Jet x = *this;
        x.c_[0][0] = 0;
        return Jet(f[0]) + x * (Jet(f[1]) + x * (Jet(f[2] / 2) + x * Jet(f[3] / 6)));
    }

    double c_[kDegree + 1][kDegree + 1] = {};
};

}  // namespace test_meshes
