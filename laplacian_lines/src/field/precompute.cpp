// SPDX-License-Identifier: GPL-3.0-or-later
// From a mesh to its field: what a redraw needs to know of each vertex, whatever the eye. The steps
// are told in precompute(), the quantities are those of the paper: √h, n, S, Δn.
#include "laplacian_lines/precompute.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "field/field_steps.h"
#include "laplacian_lines/field_columns.h"
#include "mesh/prepared_mesh.h"
#include "sums/summation_cost.h"
#include "system/large_array.h"

namespace laplacian_lines {
namespace {

constexpr int kTensorSmoothingPasses = 2;
constexpr double kFitCost = 20;  // of a pair of vertices in a fit, over that in a direct sum

// Share of the time at which each step ends, with the default options.
constexpr double kPrepared = 0.15, kSorted = 0.3, kNormals = 0.35;
constexpr double kSmoothNormals = 0.45, kFitted = 0.55, kTensors = 0.6;
constexpr double kDerivatives = 0.15;  // of the time with them

constexpr double kDrawnSigma = 0.25;  // of √h, see PrecomputeOptions::drawn_kernel_size
// Of least_sigma(), which removes noise, no lines; the first two in mean edges.
constexpr double kFineKernel = 1.3, kFineSigma = 0.8, kSigmaOfFineness = 0.75;

/// Local units; 0 if √h is at most kFineKernel edges.
double least_sigma(double kernel_size, double mean_edge) {
    const double coarse = kFineKernel * mean_edge;
    const double fineness = kernel_size * kernel_size - coarse * coarse;
    return std::min(kFineSigma * mean_edge, kSigmaOfFineness * std::sqrt(std::max(fineness, 0.)));
}

Cuts cuts_of(const PrecomputeOptions& options) {
    return options.weld_duplicates ? Cuts::Stitched : Cuts::Left;
}

/// Local units; vectors are [N].
struct LocalField {
    double kernel_size = 0, normal_sigma = 0, roughness = 0;
    std::vector<Eigen::Vector3d> normals, laplacian;
    ShapeOperators shape_operators;
};

/// The mean edge in which options count, local units.
double edge_of_options(const PreparedMesh& mesh) {
    return mesh.known_edge > 0 ? mesh.known_edge : mesh.mean_edge;
}

/// Of the smoothing of normals, local units; 0 if there is none, or if it is automatic and the
/// roughness is not known.
double smoothing_sigma(const PreparedMesh& mesh, const PrecomputeOptions& options,
                       double kernel_size, std::optional<double> roughness) {
    if (options.normal_smoothing == NormalSmoothing::None) return 0;
    if (options.normal_sigma > 0 || !roughness) return options.normal_sigma * edge_of_options(mesh);
    if (mesh.origin == Origin::Design) return 0;
    const double of_drawing = options.drawn_kernel_size > 0 ? kDrawnSigma * kernel_size : 0;
    return std::max({automatic_normal_sigma(*roughness) * edge_of_options(mesh),
                     least_sigma(kernel_size, mesh.mean_edge), of_drawing});
}

/// Replaces normals by those that the mesh has, on the side of the triangles.
void take_normals(const TriangleMesh& mesh, const PreparedMesh& prepared,
                  std::vector<Eigen::Vector3d>& normals) {
    if (mesh.normals.empty()) return;
    for_each_element(normals.size(), [&](std::size_t i) {
        const Eigen::Vector3d& n = mesh.normals[prepared.original_vertex[i]];
        if (!n.isZero()) normals[i] = n.dot(normals[i]) < 0 ? Eigen::Vector3d(-n) : n;
    });
}

ShapeOperators estimate_shape_operators(const PreparedMesh& mesh, const SpatialTree& tree,
                                        const VertexRanges& ranges,
                                        const std::vector<Eigen::Vector3d>& normals,
                                        const PrecomputeOptions& options,
                                        const StageProgress& stage) {
    if (options.gradient_estimator == GradientEstimator::TriangleFit)
        return fit_triangles(mesh, ranges, normals, stage);
    const double radius = options.gradient_radius * edge_of_options(mesh);
    refuse_costly_sum(kFitCost * pairs_cost(tree, radius),
                      "Merge close vertices, or choose a smaller Gradient Radius or the Gradient "
                      "Estimator Triangle Fit.");
    return fit_balls(mesh, tree, normals, radius, options.skip_opposite_sheet,
                     fit_triangles(mesh, ranges, normals, stage.part(0, 0.2)), stage.part(0.2, 1));
}

std::vector<Eigen::Vector3d> laplacian_of_normals(const PreparedMesh& mesh, const SpatialTree& tree,
                                                  const LocalField& local,
                                                  const PrecomputeOptions& options,
                                                  const StageProgress& stage) {
    if (options.laplace_operator == LaplaceOperator::Cotangent)
        return cotangent_laplacian(mesh, local.normals);
    if (mesh.origin == Origin::Design)
        return designed_laplacian(mesh, local.kernel_size, local.shape_operators, options, stage);
    return belkin_laplacian(mesh, tree, local.normals, local.kernel_size, local.shape_operators,
                            options, stage);
}

/// In the input's units.
FieldScale scale_of(const PreparedMesh& mesh, double kernel_size, double normal_sigma) {
    const double d = mesh.diagonal;
    return {d, mesh.mean_edge * d, kernel_size * d, normal_sigma * d};
}

/// Back to the input's order and units, for all of its vertices.
Field in_input_units(const PreparedMesh& mesh, const LocalField& local, std::size_t vertex_count) {
    Field field;
    const Eigen::Vector3f zero = Eigen::Vector3f::Zero();
    field.normals = large_array(vertex_count, zero);
    field.laplacian_normals = large_array(vertex_count, zero);
    field.shape_operators = large_array<ShapeOperator>(vertex_count);
    const double d = mesh.diagonal;
    for_each_element(mesh.size(), [&](std::size_t i) {
        const std::uint32_t v = mesh.original_vertex[i];
        field.normals[v] = local.normals[i].cast<float>();
        const auto by_d = [d](double x) { return to_float(x / d); };
        field.laplacian_normals[v] = (local.laplacian[i] / d / d).unaryExpr(&to_float);
        const SymmetricTensor& s = local.shape_operators[i];
        field.shape_operators[v] = {by_d(s.xx), by_d(s.yy), by_d(s.zz),
                                    by_d(s.yz), by_d(s.xz), by_d(s.xy)};
    });
    copy_to_welded(mesh.representative, field.normals, field.laplacian_normals,
                   field.shape_operators);
    field.scale = scale_of(mesh, local.kernel_size, local.normal_sigma);
    field.report = mesh.report;
    field.report.roughness = local.roughness;
    return field;
}

}  // namespace

Field precompute(const TriangleMesh& mesh, const PrecomputeOptions& options,
                 const Progress& progress) {
    validate(options);
    const auto stage = [&](double begin, double end, const char* name) {
        StageProgress of_step(progress, begin, end, name);
        of_step.report(0);
        return of_step;
    };
    // The usable part, in units of the bounding box's diagonal D; neighbours are near in memory.
    stage(0, kPrepared, "Preparing the mesh");
    PreparedMesh prepared = prepare_mesh(mesh, cuts_of(options), Facing::Outwards);
    stage(kPrepared, kSorted, "Sorting in space");
    const SpatialTree tree = sort_in_space(prepared);
    const VertexRanges ranges(prepared);

    // √h, the scale at which features are sought.
    LocalField local;
    local.kernel_size = kernel_size_of(prepared, options);

    // n, the normals, from whose triangles noise is smoothed out: shading with the light at the eye
    // is I = n·l.
    local.normals = vertex_normals(prepared, ranges, stage(kSorted, kNormals, "Computing normals"));
    take_normals(mesh, prepared, local.normals);
    const StageProgress smoothing = stage(kNormals, kSmoothNormals, "Smoothing normals");
    local.roughness = mesh.known_edge > 0 ? mesh.known_roughness
                                          : measure_roughness(prepared, ranges, tree, local.normals,
                                                              smoothing.part(0, 0.3));
    local.normal_sigma = smoothing_sigma(prepared, options, local.kernel_size, local.roughness);
    smooth_normals(prepared, tree, local.normal_sigma, smoothing.part(0.3, 1), local.normals);

    // S, the change of n along the surface: it gives ∇I = S l, by which a line's strength is
    // measured, as the least squares of Eq. 3 do for one eye.
    const char* const tensors = "Estimating curvature tensors";
    local.shape_operators = estimate_shape_operators(prepared, tree, ranges, local.normals, options,
                                                     stage(kSmoothNormals, kFitted, tensors));
    smooth_over_one_rings(prepared, ranges, local.normals, kTensorSmoothingPasses,
                          stage(kFitted, kTensors, tensors), local.shape_operators);

    // Δn by Eq. 2: ΔI = l·Δn is linear in the light, so a redraw finds its zeros, the lines of
    // Eq. 4, without another sum.
    const double laplacian_end = options.curvature_derivatives ? 1 - kDerivatives : 1;
    const StageProgress laplacian =
        stage(kTensors, laplacian_end, "Computing the Laplacian of the normals");
    local.laplacian = laplacian_of_normals(prepared, tree, local, options, laplacian);
    laplacian.report(1);

    Field field = in_input_units(prepared, local, mesh.positions.size());
    // C = ∇S and S̄, for other kinds of lines.
    if (options.curvature_derivatives)
        fill_curvature_derivatives(prepared, tree,
                                   stage(laplacian_end, 1, "Differentiating the curvature"), field);
    return field;
}

void add_curvature_derivatives(const TriangleMesh& mesh, Field& field, const Progress& progress) {
    if (!has_entries(field, mesh.positions.size())) refuse_field();
    const StageProgress stage(progress, 0, 1, "Differentiating the curvature");
    stage.report(0);
    PreparedMesh prepared = prepare_mesh(mesh, cuts_of(field.report), facing_of(field.report));
    const SpatialTree tree = sort_in_space(prepared);
    fill_curvature_derivatives(prepared, tree, stage.part(0.4, 1), field);
}

FieldScale measure_scale(const TriangleMesh& mesh, const PrecomputeOptions& options) {
    validate(options);
    const PreparedMesh prepared = prepare_mesh(mesh, cuts_of(options), Facing::Kept);
    const double kernel_size = kernel_size_of(prepared, options);
    return scale_of(prepared, kernel_size,
                    smoothing_sigma(prepared, options, kernel_size, std::nullopt));
}

}  // namespace laplacian_lines
