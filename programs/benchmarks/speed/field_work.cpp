// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_work.h"

#include "field/belkin_laplacian.h"
#include "field/field_steps.h"

namespace benchmarks {

using namespace laplacian_lines;

namespace {

const Progress kNoProgress;

StageProgress no_reports() {
    return {kNoProgress, 0, 1, ""};
}

}  // namespace

LaplacianAlone::LaplacianAlone(const TriangleMesh& mesh)
    : mesh_(prepare_mesh(mesh, Cuts::Left)), tree_(sort_in_space(mesh_)) {
    const PrecomputeOptions options;
    const VertexRanges ranges(mesh_);
    normals_ = vertex_normals(mesh_, ranges, options.normal_weighting, no_reports());
    smooth_normals(mesh_, tree_, std::vector<float>(mesh_.size(), 1.f),
                   automatic_normal_sigma(0) * mesh_.mean_edge, options, no_reports(), normals_);
    shape_operators_ = fit_triangles(mesh_, ranges, normals_, no_reports());
    smooth_over_one_rings(mesh_, ranges, normals_, 2, no_reports(), shape_operators_);
}

std::vector<Eigen::Vector3d> LaplacianAlone::compute(double size) const {
    const std::vector<float> kernel_sizes(mesh_.size(), float(size * mesh_.mean_edge));
    return belkin_laplacian(mesh_, tree_, normals_, kernel_sizes, shape_operators_, {},
                            no_reports());
}

}  // namespace benchmarks
