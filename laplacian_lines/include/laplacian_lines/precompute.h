// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/field.h"
#include "laplacian_lines/precompute_options.h"
#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// Computes the view-independent field of a mesh: normals, Δn, shape operators.
///
/// Sources: L. Zhang, Y. He, H. S. Seah, "Laplacian Lines for Real-Time Shape Illustration", with
/// the Laplacian of M. Belkin, J. Sun, Y. Wang, "Discrete Laplace Operator on Meshed Surfaces"
/// (SoCG 2008). The Laplacian is negative semi-definite: Δf < 0 at a maximum of f.
///
/// @throws Error: InvalidOption, InvalidMesh, EmptyMesh, TooCostly, Cancelled.
/// Thread-safe; runs on several threads (see threads.h), and the result does not depend on how
/// many.
Field precompute(const TriangleMesh& mesh, const PrecomputeOptions& options = {},
                 const Progress& progress = {});

/// Computes S̄ and C of a field of this mesh, see Field::has_derivatives(): the same as if
/// precompute() had been asked for them. What was there before is computed anew; the rest of the
/// field stays.
/// @throws Error: FieldMismatch, and those of precompute(). Thread-safe for different fields.
void add_curvature_derivatives(const TriangleMesh& mesh, Field& field,
                               const Progress& progress = {});

/// Bounding-box diagonal and mean edge of the usable part of a mesh, with the kernel size and the
/// smoothing that precompute() would use: 0 if it would choose by the roughness, which is not
/// measured here. @throws Error like precompute().
FieldScale measure_scale(const TriangleMesh& mesh, const PrecomputeOptions& options = {});

}  // namespace laplacian_lines
