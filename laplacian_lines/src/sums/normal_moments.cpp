// SPDX-License-Identifier: GPL-3.0-or-later
#include "sums/normal_moments.h"

namespace laplacian_lines {
namespace {

// Moments of degree 3, from the fifth of the first group on, and how often each occurs among the 27
// entries of the tensor.
enum { kXXX, kYYY, kZZZ, kXXY, kXXZ, kXYY, kYYZ, kXZZ, kYZZ, kXYZ, kCubic };
constexpr double kEntries[kCubic] = {1, 1, 1, 3, 3, 3, 3, 3, 3, 6};
constexpr int kFirstCubic = 4;

// Order of the moments of degree 4, the second group.
enum {
    kXXXX,
    kYYYY,
    kZZZZ,
    kXXXY,
    kXXXZ,
    kXYYY,
    kYYYZ,
    kXZZZ,
    kYZZZ,
    kXXYY,
    kXXZZ,
    kYYZZ,
    kXXYZ,
    kXYYZ,
    kXYZZ
};
// The axis that a moment of degree 3 has an odd number of factors of; 3: none.
constexpr int kOddAxis[kCubic] = {0, 1, 2, 1, 2, 0, 2, 0, 1, 3};
// Moments of degree 4 that are x, y and z times those of degree 3.
constexpr int kTimes[3][kCubic] = {
    {kXXXX, kXYYY, kXZZZ, kXXXY, kXXXZ, kXXYY, kXYYZ, kXXZZ, kXYZZ, kXXYZ},
    {kXXXY, kYYYY, kYZZZ, kXXYY, kXXYZ, kXYYY, kYYYZ, kXYZZ, kYYZZ, kXYYZ},
    {kXXXZ, kYYYZ, kZZZZ, kXXYZ, kXXZZ, kXYYZ, kYYZZ, kXZZZ, kYZZZ, kXYZZ}};

template <class Vector>
void cubic_monomials(const Vector& n, double cubic[kCubic]) {
    const double x = n.x(), y = n.y(), z = n.z(), xx = x * x, yy = y * y, zz = z * z;
    const double values[kCubic] = {x * xx, y * yy, z * zz, xx * y, xx * z,
                                   x * yy, yy * z, x * zz, y * zz, x * y * z};
    for (int i = 0; i < kCubic; ++i)
        cubic[i] = values[i];
}

template <class Real>
double dot(const double* a, const Real* b, int count) {
    double sum = 0;
    for (int i = 0; i < count; ++i)
        sum += a[i] * double(b[i]);
    return sum;
}

}  // namespace

template <class Real, int Groups>
void set_moments(double mass, const Eigen::Vector3d& normal, GridNode<Real, Groups>& node) {
    const Eigen::Vector3d mn = mass * normal;
    double cubic[kCubic];
    cubic_monomials(normal, cubic);
    Real* t = node.moments;
    t[0] = Real(mass), t[1] = Real(mn.x()), t[2] = Real(mn.y()), t[3] = Real(mn.z());
    for (int i = 0; i < kCubic; ++i)
        t[kFirstCubic + i] = Real(mass * cubic[i]);
    t[14] = t[15] = 0;
    if constexpr (Groups == 2) {
        for (int axis = 0; axis < 3; ++axis)
            for (int i = 0; i < kCubic; ++i)
                t[kMoments + kTimes[axis][i]] = Real(mn[axis] * cubic[i]);
        t[2 * kMoments - 1] = 0;
    }
}

template <class Real, int Groups>
ContractedMoments contract(const PointSums<Real, Groups>& sums, const Eigen::Vector3d& n) {
    const Real* t = sums.moments;
    const Eigen::Vector3d first(t[1], t[2], t[3]);
    if constexpr (Groups == 1)
        return {t[0], first,
                Eigen::Vector3d(sums.derivatives[0][0], sums.derivatives[1][0],
                                sums.derivatives[2][0])};
    else {
        // w(c) = 1/2 + 3/4 c - 1/4 c^3, c = n_q·n_p; powers of c contract moments with n_p. c n_q =
        // c n_q |n_q|² has degree 4, too.
        double cubic[kCubic], weights[kFirstCubic + kCubic], normal_weights[kCubic];
        const double linear[4] = {0.75 * n.x(), 0.75 * n.y(), 0.75 * n.z(), 0};
        cubic_monomials(n, cubic);
        weights[0] = 0.5;
        for (int axis = 0; axis < 3; ++axis)
            weights[1 + axis] = linear[axis];
        for (int i = 0; i < kCubic; ++i) {
            weights[kFirstCubic + i] = -0.25 * kEntries[i] * cubic[i];
            normal_weights[i] = weights[kFirstCubic + i] + linear[kOddAxis[i]];
        }
        ContractedMoments result;
        result.mass = dot(weights, t, kFirstCubic + kCubic);
        for (int axis = 0; axis < 3; ++axis) {
            result.normal[axis] = 0.5 * first[axis];
            for (int i = 0; i < kCubic; ++i)
                result.normal[axis] += normal_weights[i] * double(t[kMoments + kTimes[axis][i]]);
            result.gradient[axis] = dot(weights, sums.derivatives[axis], kFirstCubic + kCubic);
        }
        return result;
    }
}

template void set_moments(double, const Eigen::Vector3d&, GridNode<float, 1>&);
template void set_moments(double, const Eigen::Vector3d&, GridNode<float, 2>&);
template void set_moments(double, const Eigen::Vector3d&, GridNode<double, 1>&);
template void set_moments(double, const Eigen::Vector3d&, GridNode<double, 2>&);
template ContractedMoments contract(const PointSums<float, 1>&, const Eigen::Vector3d&);
template ContractedMoments contract(const PointSums<float, 2>&, const Eigen::Vector3d&);
template ContractedMoments contract(const PointSums<double, 1>&, const Eigen::Vector3d&);
template ContractedMoments contract(const PointSums<double, 2>&, const Eigen::Vector3d&);

}  // namespace laplacian_lines
