// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit_head.h"

#include <cmath>

namespace test_meshes {
namespace {

using Eigen::Vector3d;

/// `height` at the centre, times exp(-1/2) at its half axes.
struct Blob {
    Vector3d centre, half_axes;
    double height;
    bool on_both_sides;

    double at(const Vector3d& p) const {
        return height * std::exp(-0.5 * (p - centre).cwiseQuotient(half_axes).squaredNorm());
    }
};

const Blob kBlobs[] = {
    {{0, 0.2, -0.1}, {0.55, 0.6, 0.65}, 1, false},          // skull
    {{0, -0.25, 0.1}, {0.36, 0.42, 0.42}, 0.7, false},      // jaw
    {{0, -0.7, -0.2}, {0.27, 0.25, 0.28}, 1.2, false},      // neck
    {{0, 0.06, 0.68}, {0.06, 0.2, 0.1}, 0.25, false},       // bridge of the nose
    {{0, -0.08, 0.74}, {0.09, 0.08, 0.1}, 0.3, false},      // its tip
    {{0.1, -0.12, 0.66}, {0.05, 0.05, 0.07}, 0.15, true},   // its wings
    {{0.2, 0.12, 0.6}, {0.1, 0.07, 0.12}, -0.3, true},      // sockets
    {{0.2, 0.1, 0.55}, {0.06, 0.05, 0.06}, 0.25, true},     // eyes
    {{0.2, 0.25, 0.6}, {0.14, 0.05, 0.08}, 0.15, true},     // brows
    {{0.27, -0.1, 0.48}, {0.11, 0.1, 0.12}, 0.12, true},    // cheeks
    {{0, -0.27, 0.6}, {0.13, 0.035, 0.08}, 0.16, false},    // upper lip
    {{0, -0.37, 0.58}, {0.11, 0.04, 0.08}, 0.18, false},    // lower lip
    {{0, -0.32, 0.64}, {0.14, 0.022, 0.08}, -0.18, false},  // mouth
    {{0, -0.57, 0.5}, {0.12, 0.07, 0.1}, 0.25, false},      // chin
    {{0.62, 0.06, -0.1}, {0.05, 0.17, 0.11}, 0.7, true},    // ears
    {{0.7, 0.07, -0.05}, {0.06, 0.1, 0.05}, -0.45, true},   // their hollows
};
constexpr double kLevel = 0.6;
constexpr double kHalfWidth = 1.1;

Volume head_volume(int size) {
    return sampled(implicit_head, size, kHalfWidth);
}

}  // namespace

double implicit_head(const Vector3d& p) {
    double sum = 0;
    for (const Blob& blob : kBlobs) {
        sum += blob.at(p);
        if (blob.on_both_sides) sum += blob.at(p.cwiseProduct(Vector3d(-1, 1, 1)));
    }
    return kLevel - sum;
}

laplacian_lines::TriangleMesh smooth_head(int size) {
    return marching_cubes(head_volume(size));
}

laplacian_lines::TriangleMesh terraced_head(int size) {
    return marching_cubes(labels_of(head_volume(size)));
}

}  // namespace test_meshes
