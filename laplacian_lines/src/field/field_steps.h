// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "field/symmetric_tensor.h"
#include "laplacian_lines/field.h"
#include "laplacian_lines/precompute_options.h"
#include "mesh/prepared_mesh.h"
#include "mesh/spatial_tree.h"
#include "mesh/vertex_ranges.h"
#include "system/parallel.h"

/// Steps of precompute(), in order.
namespace laplacian_lines {

/// Unit normals, [N]: the mean of the incident triangles' normals, weighted by area; where they
/// cancel, that of any of them.
std::vector<Eigen::Vector3d> vertex_normals(const PreparedMesh& mesh, const VertexRanges& ranges,
                                            const StageProgress& stage);

/// The automatic √h, but of an Origin::Design. Lengths in any unit; the result has the same one.
double automatic_kernel_size(double mean_edge, double diagonal);

/// √h in local units: the option, or the automatic size.
double kernel_size_of(const PreparedMesh& mesh, const PrecomputeOptions& options);

/// How far noise has moved the vertices, in mean edges: 0 on clean meshes, however coarse. A bump
/// is the height of the mean of a vertex's neighbours above the vertex. Bumps of a form resemble
/// those around them, those of noise do not.
double vertex_noise(const PreparedMesh& mesh, const VertexRanges& ranges,
                    const std::vector<Eigen::Vector3d>& normals, const StageProgress& stage);

/// MeshReport::roughness, from unsmoothed vertex normals: the larger of noise (vertex_noise()) and
/// of terraces, in units of what automatic_normal_sigma() smooths; of CAD meshes that of terraces
/// if triangles are even and faces those of voxels, else 0.
double measure_roughness(const PreparedMesh& mesh, const VertexRanges& ranges,
                         const SpatialTree& tree, const std::vector<Eigen::Vector3d>& normals,
                         const StageProgress& stage);

/// The smoothing that this roughness asks for, in mean edges.
double automatic_normal_sigma(double roughness);

/// Replaces unit normals by the mean of those around them, weighted by mass, facing_weight(n_q·n_p)
/// and a Gaussian of the standard deviation `sigma`, local units.
void smooth_normals(const PreparedMesh& mesh, const SpatialTree& tree, double sigma,
                    const StageProgress& stage, std::vector<Eigen::Vector3d>& normals);

/// [N], local units.
using ShapeOperators = std::vector<SymmetricTensor>;

/// By the curvature tensor of each triangle: S. Rusinkiewicz, "Estimating Curvatures and Their
/// Derivatives on Triangle Meshes", 3DPVT 2004.
ShapeOperators fit_triangles(const PreparedMesh& mesh, const VertexRanges& ranges,
                             const std::vector<Eigen::Vector3d>& normals,
                             const StageProgress& stage);

/// Least squares over the vertices within `radius` (the paper's Eq. 3), but solved in the tangent
/// plane, because the 3x3 system's normal component takes up second-order terms (100 % error), and
/// for S instead of ∇I, which is linear in the eye. Keeps the given ones where the ball holds too
/// few vertices, or about on one line. `same_side`: without vertices that face away from it.
ShapeOperators fit_balls(const PreparedMesh& mesh, const SpatialTree& tree,
                         const std::vector<Eigen::Vector3d>& normals, double radius, bool same_side,
                         ShapeOperators operators, const StageProgress& stage);

/// In each pass S becomes the mean of itself and of its one-ring's mean, in which a neighbour
/// counts once for each triangle at their edge, projected on the tangent plane. Neighbours whose
/// normals turn by more than a right angle are left out.
void smooth_over_one_rings(const PreparedMesh& mesh, const VertexRanges& ranges,
                           const std::vector<Eigen::Vector3d>& normals, int passes,
                           const StageProgress& stage, ShapeOperators& operators);

/// Δn, [N], local units, by Eq. 2 of Laplacian Lines, its sum over triangles and corners written as
/// one over vertices: M. Belkin, J. Sun, Y. Wang, "Discrete Laplace Operator on Meshed Surfaces",
/// SoCG 2008. "Skip Opposite Sheet" multiplies the terms by facing_weight(n_q·n_p).
std::vector<Eigen::Vector3d> belkin_laplacian(const PreparedMesh& mesh, const SpatialTree& tree,
                                              const std::vector<Eigen::Vector3d>& normals,
                                              double kernel_size,
                                              const ShapeOperators& shape_operators,
                                              const PrecomputeOptions& options,
                                              const StageProgress& stage);

/// Δn of an Origin::Design: the sum is over points all over the triangles, however large these are,
/// instead of over the vertices. Normals are CornerNormals, not smoothed and not those that the
/// mesh brings along. At a sharp edge only the part along the normal of a curved surface that ends
/// there is kept, or 0: what is across the edge is another surface's.
std::vector<Eigen::Vector3d> designed_laplacian(const PreparedMesh& mesh, double kernel_size,
                                                const ShapeOperators& shape_operators,
                                                const PrecomputeOptions& options,
                                                const StageProgress& stage);

/// Δn, [N], local units, by cotangent weights over the vertex mass: U. Pinkall, K. Polthier,
/// "Computing Discrete Minimal Surfaces and Their Conjugates", 1993. Does not converge on irregular
/// triangulations (the paper's Fig. 2); kept for comparison.
std::vector<Eigen::Vector3d> cotangent_laplacian(const PreparedMesh& mesh,
                                                 const std::vector<Eigen::Vector3d>& normals);

/// Gives welded vertices what their representatives have in the `columns`, [N] of the input.
template <class... Column>
void copy_to_welded(const std::vector<std::uint32_t>& representative, Column&... columns) {
    for_each_element(representative.size(), [&](std::size_t v) {
        const std::uint32_t r = representative[v];
        if (r != v) ((columns[v] = columns[r]), ...);
    });
}

/// A number of a field in the mesh's unit: clamped, as tiny kernels on tiny meshes overflow.
inline float to_float(double x) {
    constexpr double largest = 1e38;
    return std::isfinite(x) ? float(std::clamp(x, -largest, largest)) : 0.f;
}

/// Fills Field::smooth_curvatures and curvature_derivatives from the rest of the field alone: value
/// and slope of the linear function, in the tangent plane, that best fits S of the vertices around
/// (TensorFits). Errors of triangle shapes and noise cancel, and borders do not bias it. With too
/// few vertices S̄ is S, and C the mean of differences within triangles.
void fill_curvature_derivatives(const PreparedMesh& mesh, const SpatialTree& tree,
                                const StageProgress& stage, Field& field);

}  // namespace laplacian_lines
