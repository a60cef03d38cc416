// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/precompute_options.h"
#include "mesh/prepared_mesh.h"
#include "mesh/spatial_tree.h"
#include "mesh/vertex_ranges.h"
#include "sums/gaussian_sums.h"
#include "system/parallel.h"

/// Steps of precompute(), in order; belkin_laplacian.h and shape_operators.h come before the last.
namespace laplacian_lines {

/// Unit normals, [N]: the weighted mean of the incident triangles' normals.
/// Max: N. Max, "Weights for Computing Vertex Normals from Facet Normals", J. Graphics Tools 1999.
std::vector<Eigen::Vector3d> vertex_normals(const PreparedMesh& mesh, const VertexRanges& ranges,
                                            NormalWeighting weighting, const StageProgress& stage);

/// The least √h that shows detail of a mesh, in the unit of its mean edge.
double least_kernel_size(double mean_edge);

/// √h in local units: the option, or the automatic size.
double global_kernel_size(const PreparedMesh& mesh, const PrecomputeOptions& options);

/// √h(p) / √h, [N]: 1, or the smoothed and clamped local edge length in mean edges (see
/// PrecomputeOptions::kernel_mode).
std::vector<float> relative_kernel_sizes(const PreparedMesh& mesh, const VertexRanges& ranges,
                                         KernelMode mode, const StageProgress& stage);

/// How far noise has moved the vertices, in mean edges: 0 on clean meshes, however coarse. A bump
/// is how far a vertex is below the mean of its neighbours. Bumps of a form are as those around
/// them, those of noise have the opposite sign as often as not.
double vertex_noise(const PreparedMesh& mesh, const VertexRanges& ranges,
                    const std::vector<Eigen::Vector3d>& normals, const StageProgress& stage);

// Clean meshes have 0. From noise of a twelfth of the edges on, contours do not follow edges.
constexpr double kLargestRoughness = 0.5;

/// MeshReport::roughness, from unsmoothed vertex normals: what vertex_noise() asks for, or terraces
/// if that is more, which show in how much more normals turn when smoothed by 1.6 mean edges
/// instead of 0.8 than by 3.2 instead of 1.6, lower quartiles of a thousand vertices. Smoothing
/// removes terraces at the finest scale, form at the coarsest. Counts less where most normals are
/// within 2 degrees of their neighbours' mean; 0 where a mesh is too coarse to tell or has too many
/// vertices near each other, and if it would be rough but has_large_faces(). Mean edges are times
/// relative_sizes[v].
double measure_roughness(const PreparedMesh& mesh, const VertexRanges& ranges,
                         const SpatialTree& tree, const std::vector<float>& relative_sizes,
                         const std::vector<Eigen::Vector3d>& normals, const StageProgress& stage);

/// Replaces unit normals by the mean of those around them, weighted by facing_weight(n_q·n_p) and a
/// Gaussian of the standard deviation `sigma` times relative_sizes[v], local units. Bilateral
/// weights also fall with the difference of normals, standard deviation `bilateral_angle` in
/// degrees, which keeps edges sharp.
void smooth_normals(const PreparedMesh& mesh, const SpatialTree& tree,
                    const std::vector<float>& relative_sizes, double sigma,
                    const PrecomputeOptions& options, const StageProgress& stage,
                    std::vector<Eigen::Vector3d>& normals);

/// Δn, [N], local units, by cotangent weights over the vertex mass: U. Pinkall, K. Polthier,
/// "Computing Discrete Minimal Surfaces and Their Conjugates", 1993. Does not converge on irregular
/// triangulations (the paper's Fig. 2); kept for comparison.
std::vector<Eigen::Vector3d> cotangent_laplacian(const PreparedMesh& mesh,
                                                 const std::vector<Eigen::Vector3d>& normals);

/// Fills Field::smooth_curvatures and curvature_derivatives from the rest of the field alone, so
/// that it does not matter where that comes from. C is the slope of the linear function, in the
/// tangent plane, that best fits S of the vertices within kDerivativeReach √h, weighted by mass,
/// nearness and how they face. The fit cancels what triangle shapes and noise add, see
/// docs/measurements.md. With too few vertices: set_ring_derivatives(). S̄ is the value of such a
/// fit, within kSmoothReach √h, at the vertex, or S with too few vertices. Borders do not bias it.
void fill_curvature_derivatives(const PreparedMesh& mesh, const SpatialTree& tree,
                                const VertexRanges& ranges, const StageProgress& stage,
                                Field& field);

}  // namespace laplacian_lines
