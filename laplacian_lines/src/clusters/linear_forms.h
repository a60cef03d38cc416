// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "clusters/cluster_data.h"

namespace laplacian_lines {

// Whatever a caller's field holds, floats can take powers of what is kept of it.
constexpr double kLargestCurvature = 1e8;  ///< S·D

/// Within ±limit; what is not a number is 0.
inline double bounded(double x, double limit) {
    return std::isnan(x) ? 0 : std::clamp(x, -limit, limit);
}
inline Eigen::Vector3d bounded(const Eigen::Vector3f& v, double factor, double limit) {
    return (v.cast<double>() * factor).unaryExpr([=](double x) { return bounded(x, limit); });
}

/// A vector at a point, whose linear form is v·(e − w p).
struct FormVector {
    Eigen::Vector3d v, p;
};

/// Writes the linear forms of a cluster's vertices, each of vector_of(i). The places that are left
/// over repeat the last vertex, which changes no "all" or "any".
template <class VectorOf>
void write_forms(FormGroup* groups, const Cluster& cluster, const VectorOf& vector_of) {
    for (unsigned i = 0; i < form_groups(cluster) * kFormGroup; ++i) {
        const FormVector vector = vector_of(std::min(i, cluster.vertex_count - 1u));
        FormGroup& group = groups[i / kFormGroup];
        for (unsigned k = 0; k < 3; ++k)
            group.numbers[k][i % kFormGroup] = float(vector.v[k]);
        group.numbers[3][i % kFormGroup] = float(vector.v.dot(vector.p));
    }
}

/// The vector of a vertex's form.
inline Eigen::Vector3f vector_of_form(const FormGroup* groups, unsigned vertex) {
    const auto& numbers = groups[vertex / kFormGroup].numbers;
    const unsigned i = vertex % kFormGroup;
    return {numbers[0][i], numbers[1][i], numbers[2][i]};
}

}  // namespace laplacian_lines
