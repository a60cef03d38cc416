// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "analytic_surface.h"
#include "laplacian_lines/field.h"
#include "laplacian_lines/line_extractor.h"

/// The right lines on smooth surfaces: from a fine mesh with the true field.
namespace reference {

struct Refinement {
    const char* name;
    std::function<test_meshes::AnalyticMesh(int level)> generate;  ///< four times the triangles
    double border = 0;  ///< what is as near to the planes x, y = ±1 is left out, for borders
};
/// Torus, ellipsoid, bumpy sphere, hills, with 1,280 to 5,120 triangles at level 0.
const std::vector<Refinement>& refinements();

/// Zeros of functions of the view, and demarcating curves. All but contours need C.
extern const std::vector<laplacian_lines::LineKind> true_kinds;

struct NamedView {
    const char* name;
    laplacian_lines::View view;
};
/// Perspective from near and from far, and orthographic.
std::vector<NamedView> views_of(const laplacian_lines::FieldScale& scale);

/// Lengths are `scale`, so that thresholds mean the same.
laplacian_lines::Field true_field(const test_meshes::AnalyticMesh& surface,
                                  const laplacian_lines::FieldScale& scale);

/// The largest distance, both ways, from what is clearly above the thresholds to anything in the
/// other drawing, even below them.
struct LineDistance {
    double largest = 0, mean = 0;  ///< D
    double length = 0;             ///< that was looked at, D
};

/// Lines of a mesh and of the surface that it samples.
class KindTruth {
public:
    /// `fine` is of the same surface.
    KindTruth(const laplacian_lines::TriangleMesh& mesh, const test_meshes::AnalyticMesh& fine,
              double border = 0);

    const laplacian_lines::FieldScale& scale() const { return field_.scale; }
    LineDistance distance(laplacian_lines::LineKind kind, const laplacian_lines::View& view) const;
    /// Of all views_of(): the mean is by length, 0 without anything to compare.
    LineDistance over_views(laplacian_lines::LineKind kind) const;

private:
    laplacian_lines::LineStyle style(laplacian_lines::LineKind kind, double factor) const;

    void add_distances(const laplacian_lines::LineSet& lines,
                       const laplacian_lines::LineSet& others, LineDistance& distance) const;

    const double border_;
    const laplacian_lines::Field field_;
    const laplacian_lines::LineExtractor found_, truth_;
};

}  // namespace reference
