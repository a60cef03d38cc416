// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/laplacian_forms.h"

#include <cmath>

#include "clusters/bounded.h"
#include "clusters/extractor_data.h"
#include "clusters/linear_forms.h"
#include "field/tensor_fits.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr double kLargestLaplacian = 1e12;
// By its own scale alone gentle forms would have no slopes for a kernel of a mean edge; by that of
// derivatives what is finest would have too many.
constexpr double kOwnShare = 0.75;
}  // namespace

double squared_scale(double kernel_size, const FieldScale& scale) {
    const double size = kernel_size / scale.diagonal, sigma = scale.normal_sigma / scale.diagonal;
    return size * size + sigma * sigma / 2;
}

LaplacianForms laplacian_forms(const PreparedMesh& mesh, const Field& field,
                               const ExtractorData& data) {
    LaplacianForms forms;
    forms.kernel_size = float(field.scale.kernel_size / field.scale.diagonal);
    const double own = squared_scale(field.scale.kernel_size, field.scale);
    const double wider = squared_scale(derivative_kernel(field.scale), field.scale);
    const double scale = wider * std::pow(own / wider, kOwnShare);
    if (data.squared_scale > 0) forms.factor = float(std::pow(scale / data.squared_scale, 1.5));
    const Cluster* last = data.clusters.empty() ? nullptr : &data.clusters.back();
    forms.groups = large_array<FormGroup>(last ? last->first_form_group + form_groups(*last) : 0);
    const double factor = data.diagonal * data.diagonal * forms.factor;
    in_parallel(data.clusters.size(), [&](std::size_t c) {
        const Cluster& cluster = data.clusters[c];
        write_forms(&forms.groups[cluster.first_form_group], cluster, [&](unsigned i) {
            const std::uint32_t v = data.vertices_of_clusters[cluster.first_vertex + i];
            const Eigen::Vector3f& laplacian = field.laplacian_normals[mesh.original_vertex[v]];
            return FormVector{bounded(laplacian, factor, kLargestLaplacian), mesh.positions[v]};
        });
    });
    return forms;
}

}  // namespace laplacian_lines
