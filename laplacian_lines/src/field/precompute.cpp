// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_lines/precompute.h"

#include <algorithm>
#include <cmath>

#include "field/belkin_laplacian.h"
#include "field/field_steps.h"
#include "field/midpoint_values.h"
#include "field/shape_operators.h"
#include "laplacian_lines/field_columns.h"
#include "mesh/prepared_mesh.h"
#include "sums/summation_cost.h"
#include "system/large_array.h"

namespace laplacian_lines {
namespace {

constexpr int kTensorSmoothingPasses = 2;
constexpr double kLargestFloat = 1e38;
constexpr std::size_t kMostBendSamples = 20000;
// Subdivisions are undone as far as edges are shorter, in D: those of a form that was made of a few
// large triangles have been cut for a reason.
constexpr double kLongestUndone = 0.025;
constexpr int kMostUndone = 16;
constexpr double kLeastChoice = 2.5;  // mean edges: a kernel that could well be smaller
constexpr double kFitCost = 20;       // of a pair of vertices in a fit, in those of a direct sum

// Share of the time at which each step ends, with the default options.
constexpr double kPrepared = 0.15, kSorted = 0.3, kSizes = 0.31, kNormals = 0.35;
constexpr double kSmoothNormals = 0.45, kFitted = 0.55, kTensors = 0.6, kLaplacian = 1;
constexpr double kDerivatives = 0.15;  // of the time that is longer by them

constexpr double kDrawnSigma = 0.25;  // of √h, see PrecomputeOptions::drawn_kernel_size
// Of triangles finer than the kernel, in mean edges: scans as they come show no less, but calmer.
constexpr double kFineSigma = 0.8, kSigmaOfFineness = 0.75;

bool smooths_by_roughness(const PrecomputeOptions& options) {
    return options.normal_smoothing != NormalSmoothing::None && options.normal_sigma == 0;
}

/// Local units, before adaptation; 0 if automatic.
double chosen_normal_sigma(const PreparedMesh& mesh, const PrecomputeOptions& options) {
    return options.normal_smoothing == NormalSmoothing::None
               ? 0
               : options.normal_sigma * mesh.mean_edge;
}

/// From 0 where the kernel is the least for these edges; local units.
double least_sigma(double kernel_size, double mean_edge) {
    const double least = least_kernel_size(mean_edge);
    const double fineness = kernel_size * kernel_size - least * least;
    return std::min(kFineSigma * mean_edge, kSigmaOfFineness * std::sqrt(std::max(fineness, 0.)));
}

/// A kernel smaller than that of the mesh before it was cut asks for what cutting has added.
PreparedMesh prepare(const TriangleMesh& mesh, const PrecomputeOptions& options, Facing facing) {
    Undoing undoing{kMostUndone};
    undoing.longest_share = kLongestUndone;
    if (options.kernel_size > 0) undoing.longest_edge = options.kernel_size;
    return prepare_mesh(mesh, options.weld_duplicates ? Cuts::Stitched : Cuts::Left, undoing,
                        facing);
}

/// Clamped: tiny kernels on tiny meshes overflow.
float to_float(double x) {
    return float(std::clamp(x, -kLargestFloat, kLargestFloat));
}

/// In the input's units.
FieldScale scale_of(const PreparedMesh& mesh, const PrecomputeOptions& options,
                    double normal_sigma) {
    const double d = mesh.diagonal;
    return {d, mesh.mean_edge * d, global_kernel_size(mesh, options) * d, normal_sigma * d};
}

/// Step by step, in local units.
class FieldComputation {
public:
    FieldComputation(const PreparedMesh& mesh, const SpatialTree& tree,
                     const PrecomputeOptions& options, const Progress& progress)
        : mesh_(mesh),
          tree_(tree),
          ranges_(mesh),
          options_(options),
          progress_(progress),
          kernel_size_(global_kernel_size(mesh, options)),
          normal_sigma_(chosen_normal_sigma(mesh, options)) {}

    void run() {
        compute_normals();
        compute_shape_operators();
        compute_laplacian();
    }

    /// Back to the input's order and units.
    Field result(std::size_t vertex_count) const {
        Field field;
        const Eigen::Vector3f zero = Eigen::Vector3f::Zero();
        field.normals = large_array(vertex_count, zero);
        field.laplacian_normals = large_array(vertex_count, zero);
        field.shape_operators = large_array<ShapeOperator>(vertex_count);
        field.kernel_sizes = large_array(vertex_count, 0.f);
        const double d = mesh_.diagonal;
        for_each_element(mesh_.size(), [&](std::size_t i) {
            const std::uint32_t v = mesh_.original_vertex[i];
            field.normals[v] = normals_[i].cast<float>();
            const auto by_d = [d](double x) { return to_float(x / d); };
            field.laplacian_normals[v] = (laplacian_[i] / d / d).unaryExpr(&to_float);
            const SymmetricTensor& s = shape_operators_[i];
            field.shape_operators[v] = {by_d(s.xx), by_d(s.yy), by_d(s.zz),
                                        by_d(s.yz), by_d(s.xz), by_d(s.xy)};
            field.kernel_sizes[v] = float(relative_sizes_[i] * kernel_size_ * d);
        });
        fill_midpoints(mesh_, field);
        copy_to_welded(field);
        field.scale = scale_of(mesh_, options_, normal_sigma_);
        field.report = mesh_.report;
        field.report.roughness = roughness_;
        field.report.kernel_bend = kernel_bend();
        if (options_.curvature_derivatives)
            fill_curvature_derivatives(mesh_, tree_, ranges_,
                                       stage(laplacian_end(), 1, "Differentiating the curvature"),
                                       field);
        return field;
    }

private:
    /// MeshReport::kernel_bend, from a sample of vertices.
    double kernel_bend() const {
        if (kernel_size_ < kLeastChoice * mesh_.mean_edge) return 0;
        const std::size_t step = mesh_.size() / kMostBendSamples + 1;
        std::vector<double> bends;
        for (std::size_t i = 0; i < mesh_.size(); i += step) {
            const double curvature = std::sqrt(shape_operators_[i].squaredNorm());
            bends.push_back(curvature * double(relative_sizes_[i]) * kernel_size_);
        }
        const auto middle = bends.begin() + std::ptrdiff_t(bends.size() / 2);
        std::nth_element(bends.begin(), middle, bends.end());
        return *middle;
    }

    void copy_to_welded(Field& field) const {
        const std::vector<std::uint32_t>& representative = mesh_.representative;
        for_each_element(representative.size(), [&](std::size_t v) {
            const std::uint32_t r = representative[v];
            if (r == v) return;
            field.normals[v] = field.normals[r];
            field.laplacian_normals[v] = field.laplacian_normals[r];
            field.shape_operators[v] = field.shape_operators[r];
            field.kernel_sizes[v] = field.kernel_sizes[r];
        });
    }

    double laplacian_end() const {
        return options_.curvature_derivatives ? kLaplacian - kDerivatives : kLaplacian;
    }

    StageProgress stage(double begin, double end, const char* name) const {
        return {progress_, begin, end, name};
    }

    void compute_normals() {
        relative_sizes_ = relative_kernel_sizes(mesh_, ranges_, options_.kernel_mode,
                                                stage(kSorted, kSizes, "Measuring edges"));
        normals_ = vertex_normals(mesh_, ranges_, options_.normal_weighting,
                                  stage(kSizes, kNormals, "Computing normals"));
        const StageProgress smoothing = stage(kNormals, kSmoothNormals, "Smoothing normals");
        roughness_ = measure_roughness(mesh_, ranges_, tree_, relative_sizes_, normals_,
                                       smoothing.part(0, 0.3));
        if (smooths_by_roughness(options_)) {
            normal_sigma_ = std::max(automatic_normal_sigma(roughness_) * mesh_.mean_edge,
                                     least_sigma(kernel_size_, mesh_.mean_edge));
            if (options_.drawn_kernel_size > 0)
                normal_sigma_ = std::max(normal_sigma_, kDrawnSigma * kernel_size_);
        }
        smooth_normals(mesh_, tree_, relative_sizes_, normal_sigma_, options_,
                       smoothing.part(0.3, 1), normals_);
    }

    void compute_shape_operators() {
        const char* name = "Estimating curvature tensors";
        const StageProgress fit = stage(kSmoothNormals, kFitted, name);
        const bool in_balls = options_.gradient_estimator == GradientEstimator::LeastSquares;
        shape_operators_ =
            fit_triangles(mesh_, ranges_, normals_, in_balls ? fit.part(0, 0.2) : fit);
        if (in_balls) fit_balls(fit.part(0.2, 1));
        smooth_over_one_rings(mesh_, ranges_, normals_, kTensorSmoothingPasses,
                              stage(kFitted, kTensors, name), shape_operators_);
    }

    void fit_balls(const StageProgress& stage) {
        const double radius = options_.gradient_radius * mesh_.mean_edge;
        refuse_endless_sum(kFitCost * pairs_cost(tree_, radius),
                           "Merge close vertices, or choose a smaller Gradient Radius or the "
                           "Gradient Estimator Triangle Fit.");
        shape_operators_ = laplacian_lines::fit_balls(
            mesh_, tree_, normals_, radius, options_.skip_opposite_sheet, shape_operators_, stage);
    }

    void compute_laplacian() {
        const StageProgress laplacian =
            stage(kTensors, laplacian_end(), "Computing the Laplacian of the normals");
        laplacian.report(0);
        if (options_.laplace_operator == LaplaceOperator::Cotangent) {
            laplacian_ = cotangent_laplacian(mesh_, normals_);
        } else {
            std::vector<float> sizes = relative_sizes_;
            for (float& size : sizes)
                size *= float(kernel_size_);
            laplacian_ = belkin_laplacian(
                mesh_, tree_, normals_, sizes, shape_operators_,
                {options_.accuracy, options_.correct_borders, options_.skip_opposite_sheet},
                laplacian);
        }
        laplacian.report(1);
    }

    const PreparedMesh& mesh_;
    const SpatialTree& tree_;
    const VertexRanges ranges_;
    const PrecomputeOptions& options_;
    const Progress& progress_;
    double kernel_size_, normal_sigma_, roughness_ = 0;
    std::vector<float> relative_sizes_;
    std::vector<Eigen::Vector3d> normals_, laplacian_;
    ShapeOperators shape_operators_;
};

}  // namespace

Field precompute(const TriangleMesh& mesh, const PrecomputeOptions& options,
                 const Progress& progress) {
    validate(options);
    StageProgress(progress, 0, kPrepared, "Preparing the mesh").report(0);
    PreparedMesh prepared = prepare(mesh, options, Facing::Outwards);
    const StageProgress sorting(progress, kPrepared, kSorted, "Sorting in space");
    sorting.report(0);
    const SpatialTree tree = sort_in_space(prepared);
    sorting.report(1);
    FieldComputation computation(prepared, tree, options, progress);
    computation.run();
    return computation.result(mesh.positions.size());
}

void add_curvature_derivatives(const TriangleMesh& mesh, Field& field, const Progress& progress) {
    if (!has_entries(field, mesh.positions.size()))
        throw Error(ErrorCode::FieldMismatch,
                    "The Laplacian lines field belongs to another mesh; compute it again.");
    const StageProgress stage(progress, 0, 1, "Differentiating the curvature");
    stage.report(0);
    PreparedMesh prepared =
        prepare_mesh(mesh, field.report.welded_vertices > 0 ? Cuts::Stitched : Cuts::Left,
                     {field.report.undone_subdivisions},
                     field.report.turned_triangles > 0 ? Facing::Outwards : Facing::Kept);
    const SpatialTree tree = sort_in_space(prepared);
    fill_curvature_derivatives(prepared, tree, VertexRanges(prepared), stage.part(0.4, 1), field);
}

FieldScale measure_scale(const TriangleMesh& mesh, const PrecomputeOptions& options) {
    validate(options);
    const PreparedMesh prepared = prepare(mesh, options, Facing::Kept);
    return scale_of(prepared, options, chosen_normal_sigma(prepared, options));
}

}  // namespace laplacian_lines
