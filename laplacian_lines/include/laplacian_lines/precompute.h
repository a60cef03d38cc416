// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/field.h"
#include "laplacian_lines/precompute_options.h"
#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// Computes the view-independent field of a mesh: normals, Δn, shape operators, kernel sizes. Sign:
/// Δf < 0 at a maximum of f. Sources: L. Zhang, Y. He, X. Xie, W. Chen, "Laplacian Lines for
/// Real-Time Shape Illustration" (I3D 2009); for the Laplacian M. Belkin, J. Sun, Y. Wang,
/// "Discrete Laplace Operator on Meshed Surfaces" (SoCG 2008). Thread-safe; any number of threads
/// gives the same. @throws Error: InvalidOption, InvalidMesh, EmptyMesh, TooCostly, Cancelled.
Field precompute(const TriangleMesh& mesh, const PrecomputeOptions& options = {},
                 const Progress& progress = {});

/// Computes S̄ and C of a field of this mesh, as precompute() does when asked; the rest stays.
/// @throws Error: FieldMismatch, and those of precompute(). Thread-safe for different fields.
void add_curvature_derivatives(const TriangleMesh& mesh, Field& field,
                               const Progress& progress = {});

/// Diagonal and mean edge of the usable part of a mesh, and the kernel size and smoothing that
/// precompute() would use; 0 for a smoothing that depends on the roughness, which is not measured
/// here. @throws Error: InvalidOption, InvalidMesh, EmptyMesh.
FieldScale measure_scale(const TriangleMesh& mesh, const PrecomputeOptions& options = {});

}  // namespace laplacian_lines
