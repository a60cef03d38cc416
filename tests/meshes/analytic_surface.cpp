// SPDX-License-Identifier: GPL-3.0-or-later
#include "analytic_surface.h"

#include <Eigen/Geometry>

namespace test_meshes {
namespace {

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

/// First fundamental form.
struct Metric {
    Jet e, f, g, root;  // root = √(eg − f²)
};

/// Δf = 1/√g (∂u((G f_u − F f_v)/√g) + ∂v((E f_v − F f_u)/√g)).
double laplace_beltrami(const Metric& m, const Jet& f) {
    const Jet fu = f.derivative_u(), fv = f.derivative_v();
    const Jet flux_u = (m.g * fu - m.f * fv) / m.root, flux_v = (m.e * fv - m.f * fu) / m.root;
    return ((flux_u.derivative_u() + flux_v.derivative_v()) / m.root).value();
}

/// dn: maps r_u to n_u, r_v to n_v and n to 0.
Eigen::Matrix3d shape_operator(const JetVector& ru, const JetVector& rv, const JetVector& n) {
    Eigen::Matrix3d from, to;
    from << value(ru), value(rv), value(n);
    to << value(derivative_u(n)), value(derivative_v(n)), Eigen::Vector3d::Zero();
    return to * from.inverse();
}

/// ∇S of all entries in space, made tangential.
std::array<Eigen::Matrix3d, 3> shape_derivative(const JetVector& ru, const JetVector& rv,
                                                const JetVector& n, const Jet& root) {
    // Gradients of u and v along the surface.
    const JetVector gu = scaled(cross(rv, n), reciprocal(root)),
                    gv = scaled(cross(n, ru), reciprocal(root));
    const JetVector nu = derivative_u(n), nv = derivative_v(n);
    Eigen::Matrix3d by_u, by_v;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const Jet entry = nu[i] * gu[j] + nv[i] * gv[j];
            by_u(i, j) = entry.derivative_u().value();
            by_v(i, j) = entry.derivative_v().value();
        }
    const Eigen::Vector3d normal = value(n);
    const Eigen::Matrix3d plane = Eigen::Matrix3d::Identity() - normal * normal.transpose();
    std::array<Eigen::Matrix3d, 3> result;
    for (int i = 0; i < 3; ++i)
        result[i] = plane * (by_u * value(gu)[i] + by_v * value(gv)[i]) * plane;
    return result;
}

struct Derivatives {
    explicit Derivatives(const Chart& chart)
        : r(chart(Jet::u(), Jet::v())), ru(derivative_u(r)), rv(derivative_v(r)) {
        const JetVector area = cross(ru, rv);
        metric = {dot(ru, ru), dot(ru, rv), dot(rv, rv), sqrt(dot(area, area))};
        n = scaled(area, reciprocal(metric.root));
    }
    JetVector r, ru, rv, n;
    Metric metric;
};

Chart torus_chart(const Torus& torus, double u, double v) {
    return [=](const Jet& du, const Jet& dv) -> JetVector {
        const Jet ring = torus.large + torus.small * cos(v + dv);
        return {ring * cos(u + du), ring * sin(u + du), torus.small * sin(v + dv)};
    };
}

}  // namespace

SurfacePoint surface_point(const Chart& chart) {
    const Derivatives d(chart);
    SurfacePoint point;
    point.position = value(d.r);
    point.normal = value(d.n);
    for (int k = 0; k < 3; ++k)
        point.laplacian_normal[k] = laplace_beltrami(d.metric, d.n[k]);
    point.shape_operator = shape_operator(d.ru, d.rv, d.n);
    point.shape_derivative = shape_derivative(d.ru, d.rv, d.n, d.metric.root);
    return point;
}

SurfacePoint surface_point(const DirectionMap& map, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d d = direction.normalized(), a = d.unitOrthogonal(), b = d.cross(a);
    return surface_point([&](const Jet& u, const Jet& v) {
        const JetVector x = each([&](int k) { return d[k] + a[k] * u + b[k] * v; });
        return map(scaled(x, reciprocal(sqrt(dot(x, x)))));
    });
}

JetVector sphere_map(const JetVector& d, double radius) {
    return scaled(d, radius);
}

JetVector ellipsoid_map(const JetVector& d, const Eigen::Vector3d& half_axes) {
    return each([&](int k) { return half_axes[k] * d[k]; });
}

JetVector bumpy_map(const JetVector& d) {
    const Jet bumps = sin(5 * d[0] + 0.3) * sin(4 * d[1] + 1) + 0.7 * sin(6 * d[2] + 2 * d[0]);
    return scaled(d, 1 + 0.06 * bumps);
}

SurfacePoint torus_point(const Torus& torus, double u, double v) {
    return surface_point(torus_chart(torus, u, v));
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
