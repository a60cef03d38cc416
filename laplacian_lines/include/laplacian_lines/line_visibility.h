// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_set.h"
#include "laplacian_lines/precompute_options.h"
#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

namespace laplacian_lines {

/// How far towards the eye a point of a line is moved before the surface can hide it, in D, and the
/// least such move on contours, in mean edges: contours follow the smoothed normals, beyond the
/// horizon of the triangles.
constexpr double kSightClearance = 0.003;
constexpr double kContourSightClearance = 1.5;
/// Largest mean edge, in D, of meshes that have many of them.
constexpr double kLargestSmoothMeanEdge = 0.025;

/// The mean edge that sight_clearance() means: larger where normals are smoothed by more than the
/// usual, since contours are then farther beyond the horizon.
inline double sight_edge(const FieldScale& scale) {
    return std::max(scale.mean_edge, scale.normal_sigma / automatic_normal_sigma(0));
}

/// The move for a kind of lines, in the unit of D and the mean edge.
inline double sight_clearance(LineKind kind, double diagonal, double mean_edge) {
    const double least = kSightClearance * diagonal;
    const double beyond_horizon = kContourSightClearance * mean_edge;
    const bool may_be_smooth = mean_edge <= kLargestSmoothMeanEdge * diagonal;
    const bool is_beyond = describe(kind).is_on_horizon && may_be_smooth;
    return is_beyond && beyond_horizon > least ? beyond_horizon : least;
}

/// Which parts of lines can be seen, by rays from points of the lines to the eye: exact, whatever
/// the size of a picture. Built once for a mesh, which may be gone afterwards.
class LineVisibility {
public:
    /// `scale` is that of the mesh's field.
    /// @throws Error(InvalidMesh) if a triangle names a vertex that does not exist, Cancelled.
    LineVisibility(const TriangleMesh& mesh, const FieldScale& scale,
                   const Progress& progress = {});
    ~LineVisibility();
    LineVisibility(LineVisibility&&) noexcept;
    LineVisibility& operator=(LineVisibility&&) noexcept;

    /// Whether a point is inside a closed surface, or where a surface with holes would close: the
    /// winding number (A. Jacobson et al., "Robust Inside-Outside Segmentation Using Generalized
    /// Winding Numbers", 2013) is above 1/2. Inside a surface that faces inwards is outside.
    bool encloses(const Eigen::Vector3d& point) const;

    /// The parts of `lines` that no triangle hides, from either side. A part is a line of its own
    /// that begins and ends where it comes into sight, to a thousandth of D, with kind, strength
    /// and slope of the whole line and its own length. Gaps and parts that are shorter than the
    /// clearance do not count.
    /// @throws Error(Cancelled). Thread-safe; runs on OpenMP's threads, which do not change the
    /// result.
    LineSet visible_parts(const View& view, const LineSet& lines,
                          const Progress& progress = {}) const;

private:
    struct Data;
    std::unique_ptr<const Data> data_;
};

}  // namespace laplacian_lines
