// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute_options.h"
#include "registry.h"

/// What several tests share.
namespace helpers {

/// √(Σ|a − b|² / Σ|b|²), over the vertices for which `use` holds (all, if it is empty).
double relative_error(const std::vector<Eigen::Vector3f>& a, const std::vector<Eigen::Vector3d>& b,
                      const std::vector<bool>& use = {});

std::vector<Eigen::Vector3d> true_laplacians(const std::vector<test_meshes::SurfacePoint>& truth);
/// Relative error of Δn against the truth.
double laplacian_error(const laplacian_lines::Field& field,
                       const std::vector<test_meshes::SurfacePoint>& truth,
                       const std::vector<bool>& use = {});
/// Relative error of S against the truth (Frobenius norm).
double shape_error(const laplacian_lines::Field& field,
                   const std::vector<test_meshes::SurfacePoint>& truth,
                   const std::vector<bool>& use = {});

/// S in the frame of a normal, as Field::smooth_curvatures has it.
Eigen::Vector3d curvature_entries(const Eigen::Matrix3d& s, const Eigen::Vector3f& normal);

/// C in the frame of a normal, as Field::curvature_derivatives has it.
Eigen::Vector4d derivative_entries(const std::array<Eigen::Matrix3d, 3>& derivative,
                                   const Eigen::Vector3f& normal);
/// Of the eight entries of C in the tangent plane, the sum of squares.
double squared_size(const Eigen::Vector4d& derivative);
/// Relative error of C against the truth, all eight entries.
double derivative_error(const laplacian_lines::Field& field,
                        const std::vector<test_meshes::SurfacePoint>& truth,
                        const std::vector<bool>& use = {});

Eigen::Matrix3d matrix(const laplacian_lines::ShapeOperator& s);

/// Finite corners that are not on one line.
bool has_area(const laplacian_lines::TriangleMesh& mesh, const laplacian_lines::Triangle& t);

/// Eq. 2 alone: no smoothing of normals, no border correction, all sources.
laplacian_lines::PrecomputeOptions plain_options(double kernel_size);

/// Every zero crossing becomes part of a line.
laplacian_lines::LineStyle all_crossings();
laplacian_lines::LineStyle all_laplacian_lines();  ///< without contours
laplacian_lines::LineStyle all_contours();         ///< without Laplacian lines

/// The same of every kind, with thresholds of theirs that nothing fails.
laplacian_lines::LineStyle all_crossings_of_all_kinds();
/// The default style with every kind.
laplacian_lines::LineStyle all_kinds();
/// A kind alone, all else at its default.
laplacian_lines::LineStyle only(laplacian_lines::LineKind kind);

/// With all that any kind of lines needs.
laplacian_lines::Field complete_field(const laplacian_lines::TriangleMesh& mesh,
                                      laplacian_lines::PrecomputeOptions options = {});

laplacian_lines::LineSet extract(const laplacian_lines::LineExtractor& extractor,
                                 const laplacian_lines::View& view,
                                 const laplacian_lines::LineStyle& style);

float total_length(const laplacian_lines::LineSet& lines);

/// `count` views around a mesh, perspective and orthographic, near and far; always the same.
std::vector<laplacian_lines::View> random_views(const laplacian_lines::TriangleMesh& mesh,
                                                int count);

/// Distance of p to the nearest of the segments of a line set.
double distance_to_lines(const Eigen::Vector3d& p, const laplacian_lines::LineSet& lines);

bool same_lines(const laplacian_lines::LineSet& a, const laplacian_lines::LineSet& b);
bool same_fields(const laplacian_lines::Field& a, const laplacian_lines::Field& b);

}  // namespace helpers
