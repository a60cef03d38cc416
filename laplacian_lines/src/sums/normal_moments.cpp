// SPDX-License-Identifier: GPL-3.0-or-later
// A grid sums over q without knowing p or its normal n. But w = facing_weight(c), c = n_q·n, is a
// polynomial,
//     w = 1/2 + 3/4 c − 1/4 c³,   c³ = Σ 3!/(i! j! k!) n_x^i n_y^j n_z^k q_x^i q_y^j q_z^k,
// over i + j + k = 3, with n_q = (q_x, q_y, q_z). So Σ m w is made of moments Σ m q_x^i q_y^j
// q_z^k, which do not depend on n, and of monomials of n. A node holds two groups of them:
//  1. degrees 0, 1 and 3, for Σ m w;
//  2. degree 4, for Σ m w n_q: c³ n_q, and c n_q as well, which is c n_q |n_q|².
#include "sums/normal_moments.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace laplacian_lines {
namespace {

// Monomials of degree 3, from the fifth place of the first group on.
constexpr std::size_t kFirstCubic = 4, kCubics = 10;
constexpr const char* kFactors[kCubics] = {"xxx", "yyy", "zzz", "xxy", "xxz",
                                           "xyy", "yyz", "xzz", "yzz", "xyz"};
constexpr double kMultinomials[kCubics] = {1, 1, 1, 3, 3, 3, 3, 3, 3, 6};  // 3!/(i! j! k!)

using Powers = std::array<int, 3>;  // of x, y and z

constexpr Powers powers_of(const char* factors) {
    Powers powers{};
    for (; *factors; ++factors)
        ++powers[std::size_t(*factors - 'x')];
    return powers;
}

/// The axis of a factor beside which the others are a square: z of xxz; 3 if there is none, of xyz.
/// The squares add up to |n_q|², by which the linear term of w is multiplied.
constexpr std::size_t axis_beside_square(const Powers& cubic) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (cubic[(axis + 1) % 3] % 2 == 0 && cubic[(axis + 2) % 3] % 2 == 0) return axis;
    return 3;
}

/// The place of a monomial of degree 4 in the second group.
constexpr int quartic_place(const Powers& quartic) {
    const int beside_x = quartic[1] + quartic[2];
    return beside_x * (beside_x + 1) / 2 + quartic[2];
}

/// By axis and cubic monomial, the place of their product.
constexpr auto kProducts = [] {
    std::array<std::array<int, kCubics>, 3> products{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < kCubics; ++i) {
            Powers powers = powers_of(kFactors[i]);
            ++powers[axis];
            products[axis][i] = quartic_place(powers);
        }
    return products;
}();

/// Of each cubic monomial.
constexpr auto kAxisBesideSquare = [] {
    std::array<std::size_t, kCubics> axes{};
    for (std::size_t i = 0; i < kCubics; ++i)
        axes[i] = axis_beside_square(powers_of(kFactors[i]));
    return axes;
}();

/// In the order of kFactors.
std::array<double, kCubics> cubic_monomials(const Eigen::Vector3d& n) {
    const double x = n.x(), y = n.y(), z = n.z(), xx = x * x, yy = y * y, zz = z * z;
    return {x * xx, y * yy, z * zz, xx * y, xx * z, x * yy, yy * z, x * zz, y * zz, x * y * z};
}

double dot(const double* a, const float* b, std::size_t count) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
        sum += a[i] * double(b[i]);
    return sum;
}

}  // namespace

void set_moments(double mass, const Eigen::Vector3d& normal, GridNode& node) {
    const Eigen::Vector3d mn = mass * normal;
    const std::array<double, kCubics> cubic = cubic_monomials(normal);
    float* t = node.moments;
    std::fill_n(t, 2 * kMoments, 0.f);  // two places of the first group and one of the second pad
    t[0] = float(mass), t[1] = float(mn.x()), t[2] = float(mn.y()), t[3] = float(mn.z());
    for (std::size_t i = 0; i < kCubics; ++i)
        t[kFirstCubic + i] = float(mass * cubic[i]);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < kCubics; ++i)
            t[kMoments + kProducts[axis][i]] = float(mn[int(axis)] * cubic[i]);
}

ContractedMoments contract(const PointSums& sums, const Eigen::Vector3d& n, bool facing) {
    const float* t = sums.moments;
    const Eigen::Vector3d first(t[1], t[2], t[3]);
    if (!facing)
        return {t[0], first,
                Eigen::Vector3d(sums.derivatives[0][0], sums.derivatives[1][0],
                                sums.derivatives[2][0])};
    // what the moments of each group are multiplied by
    double weights[kFirstCubic + kCubics], normal_weights[kCubics];
    const double linear[4] = {0.75 * n.x(), 0.75 * n.y(), 0.75 * n.z(), 0};
    const std::array<double, kCubics> cubic = cubic_monomials(n);
    weights[0] = 0.5;
    std::copy_n(linear, 3, weights + 1);
    for (std::size_t i = 0; i < kCubics; ++i) {
        weights[kFirstCubic + i] = -0.25 * kMultinomials[i] * cubic[i];
        normal_weights[i] = weights[kFirstCubic + i] + linear[kAxisBesideSquare[i]];
    }
    ContractedMoments result;
    result.mass = dot(weights, t, kFirstCubic + kCubics);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double& normal = result.normal[int(axis)];
        normal = 0.5 * first[int(axis)];
        for (std::size_t i = 0; i < kCubics; ++i)
            normal += normal_weights[i] * double(t[kMoments + kProducts[axis][i]]);
        result.gradient[int(axis)] = dot(weights, sums.derivatives[axis], kFirstCubic + kCubics);
    }
    return result;
}

}  // namespace laplacian_lines
