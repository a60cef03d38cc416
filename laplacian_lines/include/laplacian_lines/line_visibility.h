// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_set.h"
#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

namespace laplacian_lines {

/// How far towards the eye a point of a line is moved before the surface can hide it, in D, and the
/// least such move on contours, in mean edges: contours follow the smoothed normals, beyond the
/// horizon of the triangles.
constexpr double kSightClearance = 0.003;
constexpr double kContourSightClearance = 1.5;

/// The mean edge that sight_clearance() means, mesh units: larger where normals are smoothed by
/// more than the usual, since contours are then farther beyond the horizon; 0 where contours follow
/// the edges of the mesh, as on coarse ones.
double sight_edge(const Field& field);

/// The move for a kind of lines, in the unit of D and of `sight_edge`.
inline double sight_clearance(LineKind kind, double diagonal, double sight_edge) {
    const double beyond = describe(kind).is_on_horizon ? kContourSightClearance * sight_edge : 0;
    return std::max(kSightClearance * diagonal, beyond);
}

/// Lines, cut where they come into sight or go out of it.
struct LineParts {
    LineSet seen, hidden;
};

/// Which parts of lines can be seen, by rays from points of the lines to the eye: exact, whatever
/// the size of a picture. Built once for a mesh, which may be gone afterwards.
class LineVisibility {
public:
    /// `field` is that of the mesh; its scale and report count.
    /// @throws Error(InvalidMesh) if a triangle names a vertex that does not exist, Cancelled.
    LineVisibility(const TriangleMesh& mesh, const Field& field, const Progress& progress = {});
    /// Of several surfaces that hide each other: `mesh` has all of them, `fields` that of each; a
    /// surface's lines are judged by the lengths of its own field.
    LineVisibility(const TriangleMesh& mesh, const std::vector<const Field*>& fields,
                   const Progress& progress = {});
    ~LineVisibility();
    LineVisibility(LineVisibility&&) noexcept;
    LineVisibility& operator=(LineVisibility&&) noexcept;

    /// Whether a point is inside a closed surface, or where a surface with holes would close: the
    /// winding number (A. Jacobson et al., "Robust Inside-Outside Segmentation Using Generalized
    /// Winding Numbers", 2013) is above 1/2. Inside a surface that faces inwards is outside.
    bool encloses(const Eigen::Vector3d& point) const;

    /// The parts of `lines` that no triangle hides, from either side. A part is a line of its own
    /// that begins and ends where an outline among `lines` crosses it in the picture or a contour
    /// turns back, elsewhere where it comes into sight, to a thousandth of D; with kind, strength
    /// and slope of the whole line and its own length. Gaps and parts that are shorter than the
    /// clearance do not count. How it is decided: docs/algorithms.md.
    /// @throws Error(Cancelled). Thread-safe; runs on OpenMP's threads, which do not change the
    /// result.
    LineSet visible_parts(const View& view, const LineSet& lines,
                          const Progress& progress = {}) const;

    /// The same with what is hidden.
    LineParts parts(const View& view, const LineSet& lines, const Progress& progress = {}) const;

    /// The same of the lines of each surface, in the order of their fields; the parts are in one
    /// set.
    LineParts parts(const View& view, const std::vector<LineSet>& lines,
                    const Progress& progress = {}) const;

private:
    struct Data;
    LineParts parts_of(const View& view, const LineSet& lines,
                       const std::vector<std::size_t>& surfaces, const Progress& progress) const;

    std::unique_ptr<const Data> data_;
};

}  // namespace laplacian_lines
