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

/// Steps of precompute(), in their order. belkin_laplacian.h and shape_operators.h, which come
/// before the last one, have structures of their own.
namespace laplacian_lines {

/// Unit vertex normals as the weighted mean of the incident triangles' normals, [N].
/// Max: N. Max, "Weights for Computing Vertex Normals from Facet Normals", J. Graphics Tools 1999.
std::vector<Eigen::Vector3d> vertex_normals(const PreparedMesh& mesh, const VertexRanges& ranges,
                                            NormalWeighting weighting, const StageProgress& stage);

/// √h of the whole mesh in local units: the option, or the automatic size.
double global_kernel_size(const PreparedMesh& mesh, const PrecomputeOptions& options);

/// √h(p) / √h for every vertex, [N]: 1 everywhere, or the local edge length in mean edges,
/// smoothed and clamped (see PrecomputeOptions::kernel_mode).
std::vector<float> relative_kernel_sizes(const PreparedMesh& mesh, const VertexRanges& ranges,
                                         KernelMode mode, const StageProgress& stage);

/// Whether the triangles of a coarse mesh are turned by noise: their normals differ from those of
/// the best quadric through their neighbours by about as much everywhere, and by as much as that
/// bends. On a clean coarse mesh they do so at its edges and details only. Looks at the two rings
/// of triangles around a thousand vertices. False on meshes that are too fine to be drawn by their
/// triangles, and on those that are too coarse to tell. The mesh is sorted in space; the number of
/// threads does not matter.
bool has_noisy_facets(const PreparedMesh& mesh);

/// MeshReport::roughness from vertex normals that nothing has smoothed yet: how much more the
/// normals turn when they are smoothed by 1.6 mean edges instead of 0.8 than by 3.2 instead of 1.6,
/// lower quartiles of a thousand vertices. Smoothing takes noise away at the finest scale, form
/// at the coarsest. It counts less where most normals keep within 2 degrees of their neighbours'
/// mean; 0 where a mesh is too coarse to tell, or has too many vertices near each other. At least 1
/// if has_noisy_facets(). Mean edges are times relative_sizes[v] at each vertex, as those of the
/// smoothing.
double measure_roughness(const PreparedMesh& mesh, const SpatialTree& tree,
                         const std::vector<float>& relative_sizes,
                         const std::vector<Eigen::Vector3d>& normals);

/// Replaces unit normals by the weighted mean of those around them, weighted by how much they face
/// the same way (facing_weight(n_q·n_p)). `sigma`: standard deviation of the Gaussian in local
/// units, times relative_sizes[v] at each vertex. Bilateral weights also fall with the difference
/// of the normals, with the standard deviation `bilateral_angle` in degrees, so that edges stay
/// sharp.
void smooth_normals(const PreparedMesh& mesh, const SpatialTree& tree,
                    const std::vector<float>& relative_sizes, double sigma,
                    const PrecomputeOptions& options, const StageProgress& stage,
                    std::vector<Eigen::Vector3d>& normals);

/// Δn of all vertices, [N], local units, with cotangent weights divided by the vertex mass:
/// U. Pinkall, K. Polthier, "Computing Discrete Minimal Surfaces and Their Conjugates", 1993.
/// Does not converge on irregular triangulations (the paper's Fig. 2); kept to compare with.
std::vector<Eigen::Vector3d> cotangent_laplacian(const PreparedMesh& mesh,
                                                 const std::vector<Eigen::Vector3d>& normals);

/// Fills Field::smooth_curvatures and curvature_derivatives from the rest of the field alone,
/// whether it has just been computed or comes from elsewhere: the same bits.
///
/// C is the slope of the linear function of the place in the tangent plane that best fits the S of
/// the vertices within kDerivativeReach √h, each by its mass, its nearness and how it faces. A fit
/// takes away what the triangles' shapes and noise do; docs/accuracy.md compares it with other
/// ways. Where there are too few vertices for one: set_ring_derivatives().
///
/// S̄ is the value, at the vertex, of such a function of the vertices within kSmoothReach √h, or S
/// where there are too few. Borders do not bias it.
void fill_curvature_derivatives(const PreparedMesh& mesh, const SpatialTree& tree,
                                const VertexRanges& ranges, const StageProgress& stage,
                                Field& field);

}  // namespace laplacian_lines
