// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_set.h"

namespace benchmarks {

/// What ridges and valleys are compared with: crest lines as they are usually defined, traced. With
/// k₁ ≥ k₂ the principal curvatures along e₁ and e₂ and C the derivative of the shape operator,
/// ridges are the zeros of C(e₁, e₁, e₁) at which it falls along e₁, where k₁ > |k₂|. Valleys are
/// the ridges of the surface turned inside out. e₁ has no sign: it is flipped to agree within a
/// triangle, and where it turns by more than 45° there is no line, nor where k₁ and k₂ are nearly
/// the same.
/// Source: Y. Ohtake, A. Belyaev, H.-P. Seidel, "Ridge-Valley Lines on Meshes via Implicit Surface
/// Fitting", SIGGRAPH 2004; S and C are the field's instead of those of a fitted surface.
///
/// `kind` is Ridge or Valley; the field needs its curvature_derivatives. A line's strength is their
/// measure, the integral of the curvature along it, which has no unit; `gradient` is the curvature
/// times D; opacity and weight are 1.
laplacian_lines::LineSet crest_lines(const laplacian_lines::TriangleMesh& mesh,
                                     const laplacian_lines::Field& field,
                                     laplacian_lines::LineKind kind);

/// The lines of at least some strength.
laplacian_lines::LineSet lines_of_strength(const laplacian_lines::LineSet& lines, double least);

/// The least strength at which lines are together about as long as `length`, in D: midway, as a
/// factor, between the weakest that is kept and the strongest that is not.
double strength_for_length(const laplacian_lines::LineSet& lines, double length);

}  // namespace benchmarks
