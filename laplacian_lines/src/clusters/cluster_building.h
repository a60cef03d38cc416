// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "clusters/extractor_data.h"
#include "mesh/prepared_mesh.h"
#include "system/parallel.h"

namespace laplacian_lines {

// Whatever a caller's field holds, floats can take powers of what is kept of it.
constexpr double kLargestCurvature = 1e8;  ///< S·D

/// Within ±limit; what is not a number is 0. Vectors are multiplied by the factor before.
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

/// Writes the clusters of a mesh, and what it is as a whole, into `data`, whose diagonal and
/// is_rough are set. The number of threads does not matter.
void build_clusters(const PreparedMesh& mesh, const Field& field, const StageProgress& stage,
                    ExtractorData& data);

}  // namespace laplacian_lines
