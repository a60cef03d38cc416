// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators.h"

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

namespace test_meshes {
namespace {

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

using JetVector = std::array<Jet, 3>;
/// A parametrization around the point (0, 0); r_u × r_v points outward.
using Chart = std::function<JetVector(const Jet& u, const Jet& v)>;
/// p = map(d), d a unit direction from the origin.
using DirectionMap = std::function<JetVector(const JetVector& direction)>;

template <class Function>
JetVector each(Function f) {
    return {f(0), f(1), f(2)};
}

JetVector scaled(const JetVector& a, const Jet& s) {
    return each([&](int k) { return a[k] * s; });
}
Jet dot(const JetVector& a, const JetVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
JetVector cross(const JetVector& a, const JetVector& b) {
    return each([&](int k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        return a[l] * b[m] - a[m] * b[l];
    });
}
JetVector derivative_u(const JetVector& a) {
    return each([&](int k) { return a[k].derivative_u(); });
}
JetVector derivative_v(const JetVector& a) {
    return each([&](int k) { return a[k].derivative_v(); });
}
Eigen::Vector3d value(const JetVector& a) {
    return {a[0].value(), a[1].value(), a[2].value()};
}

/// With the first fundamental form E, F, G and √(EG − F²).
struct Derivatives {
    explicit Derivatives(const Chart& chart)
        : r(chart(Jet::u(), Jet::v())), ru(derivative_u(r)), rv(derivative_v(r)) {
        const JetVector area = cross(ru, rv);
        root = sqrt(dot(area, area));
        n = scaled(area, reciprocal(root));
    }
    JetVector r, ru, rv, n;
    Jet e = dot(ru, ru), f = dot(ru, rv), g = dot(rv, rv), root;
};

/// Δx = 1/√ (∂u((G x_u − F x_v)/√) + ∂v((E x_v − F x_u)/√)), √ for √(EG − F²).
double laplace_beltrami(const Derivatives& d, const Jet& x) {
    const Jet xu = x.derivative_u(), xv = x.derivative_v();
    const Jet flux_u = (d.g * xu - d.f * xv) / d.root, flux_v = (d.e * xv - d.f * xu) / d.root;
    return ((flux_u.derivative_u() + flux_v.derivative_v()) / d.root).value();
}

/// dn: maps r_u to n_u, r_v to n_v and n to 0.
Eigen::Matrix3d shape_operator(const Derivatives& d) {
    Eigen::Matrix3d from, to;
    from << value(d.ru), value(d.rv), value(d.n);
    to << value(derivative_u(d.n)), value(derivative_v(d.n)), Eigen::Vector3d::Zero();
    return to * from.inverse();
}

/// ∇S of all entries in space, made tangential.
std::array<Eigen::Matrix3d, 3> shape_derivative(const Derivatives& d) {
    // Gradients of u and v along the surface.
    const JetVector gu = scaled(cross(d.rv, d.n), reciprocal(d.root)),
                    gv = scaled(cross(d.n, d.ru), reciprocal(d.root));
    const JetVector nu = derivative_u(d.n), nv = derivative_v(d.n);
    Eigen::Matrix3d by_u, by_v;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const Jet entry = nu[i] * gu[j] + nv[i] * gv[j];
            by_u(i, j) = entry.derivative_u().value();
            by_v(i, j) = entry.derivative_v().value();
        }
    const Eigen::Vector3d normal = value(d.n);
    const Eigen::Matrix3d plane = Eigen::Matrix3d::Identity() - normal * normal.transpose();
    std::array<Eigen::Matrix3d, 3> result;
    for (int i = 0; i < 3; ++i)
        result[i] = plane * (by_u * value(gu)[i] + by_v * value(gv)[i]) * plane;
    return result;
}

/// By the chart's derivatives alone: Δn is the Laplace-Beltrami operator on each component of the
/// normal.
SurfacePoint surface_point(const Chart& chart) {
    const Derivatives d(chart);
    SurfacePoint point;
    point.position = value(d.r);
    point.normal = value(d.n);
    for (int k = 0; k < 3; ++k)
        point.laplacian_normal[k] = laplace_beltrami(d, d.n[k]);
    point.shape_operator = shape_operator(d);
    point.shape_derivative = shape_derivative(d);
    return point;
}

SurfacePoint surface_point(const DirectionMap& map, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d d = direction.normalized(), a = d.unitOrthogonal(), b = d.cross(a);
    return surface_point([&](const Jet& u, const Jet& v) {
        const JetVector x = each([&](int k) { return d[k] + a[k] * u + b[k] * v; });
        return map(scaled(x, reciprocal(sqrt(dot(x, x)))));
    });
}

}  // namespace

SurfacePoint ellipsoid_point(const Eigen::Vector3d& direction, const Eigen::Vector3d& half_axes) {
    return surface_point(
        [&](const JetVector& d) { return each([&](int k) { return half_axes[k] * d[k]; }); },
        direction);
}

SurfacePoint bumpy_point(const Eigen::Vector3d& direction) {
    return surface_point(
        [](const JetVector& d) {
            const Jet bumps =
                sin(5 * d[0] + 0.3) * sin(4 * d[1] + 1) + 0.7 * sin(6 * d[2] + 2 * d[0]);
            return scaled(d, 1 + 0.06 * bumps);
        },
        direction);
}

SurfacePoint torus_point(const Torus& torus, double u, double v) {
    return surface_point([&](const Jet& du, const Jet& dv) -> JetVector {
        const Jet ring = torus.large + torus.small * cos(v + dv);
        return {ring * cos(u + du), ring * sin(u + du), torus.small * sin(v + dv)};
    });
}

SurfacePoint closed_form_torus_point(const Torus& torus, double u, double v) {
    const double ring = torus.large + torus.small * std::cos(v);
    const double k1 = std::cos(v) / ring, k2 = 1 / torus.small;
    const Eigen::Vector3d eu(-std::sin(u), std::cos(u), 0);
    const Eigen::Vector3d radial(std::cos(u), std::sin(u), 0);
    const Eigen::Vector3d n = std::cos(v) * radial + std::sin(v) * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d ev = -std::sin(v) * radial + std::cos(v) * Eigen::Vector3d::UnitZ();
    const double trace_slope = -torus.large * std::sin(v) / (ring * ring) / torus.small;
    const Eigen::Matrix3d uu = eu * eu.transpose(), uv = eu * ev.transpose() + ev * eu.transpose();
    return {ring * radial + torus.small * std::sin(v) * Eigen::Vector3d::UnitZ(),
            n,
            -(k1 * k1 + k2 * k2) * n + trace_slope * ev,
            k1 * uu + k2 * ev * ev.transpose(),
            {trace_slope * (eu.x() * uv + ev.x() * uu), trace_slope * (eu.y() * uv + ev.y() * uu),
             trace_slope * (eu.z() * uv + ev.z() * uu)}};
}

SurfacePoint hills_point(double x, double y) {
    return surface_point([&](const Jet& du, const Jet& dv) -> JetVector {
        const Jet px = x + du, py = y + dv;
        return {px, py, 0.1 * sin(5 * px + 0.4) * cos(4 * py) + 0.05 * sin(7 * py - 3 * px)};
    });
}

}  // namespace test_meshes
