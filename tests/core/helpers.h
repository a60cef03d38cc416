// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute_options.h"
#include "registry.h"

namespace helpers {

/// √(Σ|a − b|² / Σ|b|²) over the vertices, or those that satisfy `use`.
double relative_error(const std::vector<Eigen::Vector3f>& a, const std::vector<Eigen::Vector3d>& b);
double laplacian_error(const laplacian_lines::Field& field,
                       const std::vector<test_meshes::SurfacePoint>& truth,
                       const std::vector<bool>& use = {});
double shape_error(const laplacian_lines::Field& field,
                   const std::vector<test_meshes::SurfacePoint>& truth);
double derivative_error(const laplacian_lines::Field& field,
                        const std::vector<test_meshes::SurfacePoint>& truth);

/// S in the frame of a normal, as Field::smooth_curvatures has it.
Eigen::Vector3d curvature_entries(const Eigen::Matrix3d& s, const Eigen::Vector3f& normal);

Eigen::Matrix3d matrix(const laplacian_lines::ShapeOperator& s);

/// Finite corners, not on one line.
bool has_area(const laplacian_lines::TriangleMesh& mesh, const laplacian_lines::Triangle& t);

/// Eq. 2 alone: no smoothing of normals, no border correction, all sources.
laplacian_lines::PrecomputeOptions uncorrected_options(double kernel_size);

laplacian_lines::LineStyle all_crossings();
laplacian_lines::LineStyle all_laplacian_lines();  ///< without contours
laplacian_lines::LineStyle all_contours();         ///< without Laplacian lines

/// Of every kind.
laplacian_lines::LineStyle all_crossings_of_all_kinds();
laplacian_lines::LineStyle all_kinds();
/// One kind, all else at its default.
laplacian_lines::LineStyle only(laplacian_lines::LineKind kind);

/// Whether only the visibility of a kind's lines depends on the view.
bool lies_on_the_surface(laplacian_lines::LineKind kind);

/// That of the smooth surface, with S̄ = S. Lengths are `scale`, so that thresholds mean the same.
laplacian_lines::Field true_field(const test_meshes::AnalyticMesh& surface,
                                  const laplacian_lines::FieldScale& scale);

/// With what any kind needs.
laplacian_lines::Field complete_field(const laplacian_lines::TriangleMesh& mesh,
                                      laplacian_lines::PrecomputeOptions options = {});

laplacian_lines::LineSet extract(const laplacian_lines::LineExtractor& extractor,
                                 const laplacian_lines::View& view,
                                 const laplacian_lines::LineStyle& style);

float total_length(const laplacian_lines::LineSet& lines);  ///< D

/// Perspective and orthographic, near and far; always the same.
std::vector<laplacian_lines::View> random_views(const laplacian_lines::TriangleMesh& mesh,
                                                int count);

using Counts = std::function<bool(const laplacian_lines::ViewLine&, const Eigen::Vector3d& point)>;
/// Of segments both of whose ends count, mesh units.
double length_of(
    const std::vector<laplacian_lines::ViewLine>& lines,
    const Counts& counts = [](const auto&, const auto&) { return true; });

double distance_to_lines(const Eigen::Vector3d& p, const laplacian_lines::LineSet& lines);

using Edge = std::pair<std::uint32_t, std::uint32_t>;
/// Of a mesh, that lines follow: sorted vertices. @throws std::logic_error if they leave them
std::multiset<Edge> edges_of(const laplacian_lines::TriangleMesh& mesh,
                             const laplacian_lines::LineSet& lines);

/// Between front and back, however the two triangles of an edge are oriented.
std::vector<Edge> horizon_of(const laplacian_lines::TriangleMesh& mesh,
                             const laplacian_lines::View& view);

bool same_lines(const laplacian_lines::LineSet& a, const laplacian_lines::LineSet& b);

/// In all columns, bit by bit.
bool same_fields(const laplacian_lines::Field& a, const laplacian_lines::Field& b);

}  // namespace helpers
