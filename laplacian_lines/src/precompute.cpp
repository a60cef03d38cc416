// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_lines/precompute.h"

#include "belkin_laplacian.h"
#include "cotangent_laplacian.h"
#include "kernel_sizes.h"
#include "normal_smoothing.h"
#include "prepared_mesh.h"
#include "shape_operators.h"
#include "vertex_normals.h"

namespace laplacian_lines {
namespace {

constexpr int kTensorSmoothingPasses = 2;

/// Standard deviation of the normals' smoothing in local units, before adaptation.
double global_normal_sigma(const PreparedMesh& mesh, const PrecomputeOptions& options) {
    return options.normal_smoothing == NormalSmoothing::None
               ? 0
               : options.normal_sigma * mesh.mean_edge;
}

/// In the input's units.
FieldScale scale_of(const PreparedMesh& mesh, const PrecomputeOptions& options) {
    const double d = mesh.diagonal;
    return {d, mesh.mean_edge * d, global_kernel_size(mesh, options) * d,
            global_normal_sigma(mesh, options) * d};
}

/// The computation on the prepared mesh, step by step; everything in local units.
class FieldComputation {
public:
    FieldComputation(const PreparedMesh& mesh, const SpatialTree& tree,
                     const PrecomputeOptions& options, const Progress& progress)
        : mesh_(mesh),
          tree_(tree),
          options_(options),
          progress_(progress),
          relative_sizes_(relative_kernel_sizes(mesh, options.kernel_mode)),
          kernel_size_(global_kernel_size(mesh, options)),
          normal_sigma_(global_normal_sigma(mesh, options)) {}

    void run() {
        compute_normals();
        compute_shape_operators();
        compute_laplacian();
    }

    /// Back to the input's order and units.
    Field result(std::size_t vertex_count) const {
        Field field;
        field.normals.assign(vertex_count, Eigen::Vector3f::Zero());
        field.laplacian_normals.assign(vertex_count, Eigen::Vector3f::Zero());
        field.shape_operators.assign(vertex_count, ShapeOperator{});
        field.kernel_sizes.assign(vertex_count, 0.f);
        const double d = mesh_.diagonal;
        for (std::size_t i = 0; i < mesh_.size(); ++i) {
            const std::uint32_t v = mesh_.original_vertex[i];
            field.normals[v] = normals_[i].cast<float>();
            field.laplacian_normals[v] = (laplacian_[i] / d / d).cast<float>();
            const Eigen::Matrix3f s = (shape_operators_[i] / d).cast<float>();
            field.shape_operators[v] = {s(0, 0), s(1, 1), s(2, 2), s(1, 2), s(0, 2), s(0, 1)};
            field.kernel_sizes[v] = float(relative_sizes_[i] * kernel_size_ * d);
        }
        field.scale = scale_of(mesh_, options_);
        field.report = mesh_.report;
        return field;
    }

private:
    void compute_normals() {
        normals_ = vertex_normals(mesh_, options_.normal_weighting);
        smooth_normals(mesh_, tree_, relative_sizes_, normal_sigma_, options_,
                       StageProgress(progress_, 0.1, 0.2, "Smoothing normals"), normals_);
    }

    void compute_shape_operators() {
        const StageProgress stage(progress_, 0.2, 0.4, "Estimating curvature tensors");
        stage.report(0);
        shape_operators_ = fit_triangles(mesh_, normals_);
        if (options_.gradient_estimator == GradientEstimator::LeastSquares)
            shape_operators_ =
                fit_balls(mesh_, tree_, normals_, options_.gradient_radius * mesh_.mean_edge,
                          options_.skip_opposite_sheet, shape_operators_, stage);
        for (int pass = 0; pass < kTensorSmoothingPasses; ++pass)
            smooth_over_one_rings(mesh_, normals_, shape_operators_);
    }

    void compute_laplacian() {
        const StageProgress stage(progress_, 0.4, 1, "Computing the Laplacian of the normals");
        stage.report(0);
        if (options_.laplace_operator == LaplaceOperator::Cotangent) {
            laplacian_ = cotangent_laplacian(mesh_, normals_);
        } else {
            std::vector<float> sizes = relative_sizes_;
            for (float& size : sizes)
                size *= float(kernel_size_);
            laplacian_ = belkin_laplacian(
                mesh_, tree_, normals_, sizes, shape_operators_,
                {options_.accuracy, options_.correct_borders, options_.skip_opposite_sheet}, stage);
        }
        stage.report(1);
    }

    const PreparedMesh& mesh_;
    const SpatialTree& tree_;
    const PrecomputeOptions& options_;
    const Progress& progress_;
    std::vector<float> relative_sizes_;
    double kernel_size_, normal_sigma_;
    std::vector<Eigen::Vector3d> normals_, laplacian_;
    std::vector<Eigen::Matrix3d> shape_operators_;
};

}  // namespace

Field precompute(const TriangleMesh& mesh, const PrecomputeOptions& options,
                 const Progress& progress) {
    validate(options);
    const StageProgress stage(progress, 0, 0.1, "Preparing the mesh");
    stage.report(0);
    PreparedMesh prepared = prepare_mesh(mesh);
    stage.report(0.7);
    const SpatialTree tree = sort_in_space(prepared);
    stage.report(1);
    FieldComputation computation(prepared, tree, options, progress);
    computation.run();
    return computation.result(mesh.positions.size());
}

FieldScale measure_scale(const TriangleMesh& mesh, const PrecomputeOptions& options) {
    validate(options);
    return scale_of(prepare_mesh(mesh), options);
}

}  // namespace laplacian_lines
