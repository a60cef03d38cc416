// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_set.h"
#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

namespace laplacian_lines {

/// How far towards the eye a point of a line is moved before the depths of a redraw can hide it, in
/// D, and the least such move on contours, in mean edges: contours of a redraw follow the smoothed
/// normals, beyond the horizon of the triangles.
constexpr double kSightClearance = 0.003;
constexpr double kContourSightClearance = 1.5;

/// The mean edge that sight_clearance() means, mesh units: larger where normals are smoothed by
/// more than the usual, since contours are then farther beyond the horizon; 0 where contours follow
/// the edges of the mesh, as on coarse ones.
double sight_edge(const Field& field);

/// The move for a kind of lines, in the unit of D and of `sight_edge`.
inline double sight_clearance(LineKind kind, double diagonal, double sight_edge) {
    const double beyond = describe(kind).is_on_horizon ? kContourSightClearance * sight_edge : 0;
    return beyond > kSightClearance * diagonal ? beyond : kSightClearance * diagonal;
}

/// Whether a line of this kind runs along the horizon of the triangles between two of its points,
/// on an edge of the mesh, whose points have no gradient; other parts of contours are near it only.
inline bool follows_edge(LineKind kind, const LinePoint& from, const LinePoint& to) {
    return describe(kind).is_on_horizon && from.gradient == 0 && to.gradient == 0;
}

/// The lines of a view as they lie on the surface, for LineVisibility to look at: unsmoothed, so
/// that each of their segments is on a triangle, creases whole, and what is beside contours not
/// faded. Contours and borders are left out: LineVisibility has the mesh's own.
/// @throws Error as LineExtractor::extract().
LineSet extract_on_surface(const LineExtractor& extractor, const View& view, const LineStyle& style,
                           ExtractionScratch& scratch);

/// What is drawn of a view, see LineVisibility.
struct SightOptions {
    /// Which edges of the mesh are wanted: contours, borders and creases.
    LineKindSet shows = LineKindSet::defaults();
    /// As LineStyle::line_smoothing: of lines on the surface, and in space of smooth contours.
    double line_smoothing = 1.2;
    bool has_hidden = false;  ///< also what is hidden of the mesh's edges
    /// Lines go on as they do in the picture, at a contour from what is before it to what is
    /// behind: then outlines are closed. Otherwise as they do in space, each of one kind.
    bool in_picture = false;
    /// As LineStyle::shortest_contour, D: how far contours and borders that meet no others have to
    /// reach.
    double shortest_contour = 0;
};

constexpr std::uint32_t kNoSightNode = 0xffffffffu;

/// A point of a line that is seen or hidden as a whole.
struct SightPoint {
    Eigen::Vector3d position;         ///< mesh coordinates
    float weight, gradient, opacity;  ///< as of LinePoint
    /// Lines that meet in the picture have points of equal numbers there; kNoSightNode: no line
    /// meets this one there.
    std::uint32_t node;
    /// On an edge of the form; elsewhere a line may be smoothed.
    bool is_exact;
};

/// From a junction to the next one.
struct SightLine {
    LineKind kind;
    bool closed;  ///< ends with a copy of its first point
    bool is_hidden;
    bool is_outline;  ///< nothing is on one side of it: the outlines of a view are closed
    /// For contours and borders: how far behind them the surface is at most, mesh units.
    float jump;
    float strength, slope;  ///< of the whole line that it is part of, see Polyline
    std::vector<SightPoint> points;
};

/// Lines, cut where they come into sight or go out of it.
struct LineParts {
    LineSet seen, hidden;
};

/// Which parts of lines are seen from an eye, exactly and for all of them in one way: contours,
/// borders, creases and cuts are edges of the mesh; other lines lie on its triangles. All are
/// divided where they cross contours and borders in the picture, and one ray decides about each
/// piece. docs/algorithms.md says how. Built once for a mesh, of any topology and winding, which
/// may be gone afterwards. Thread-safe; the number of threads does not change results.
class LineVisibility {
public:
    /// @throws Error(InvalidMesh) if a triangle names a vertex that does not exist, Cancelled.
    explicit LineVisibility(const TriangleMesh& mesh, const Progress& progress = {});
    ~LineVisibility();
    LineVisibility(LineVisibility&&) noexcept;
    LineVisibility& operator=(LineVisibility&&) noexcept;

    /// Whether a point is inside a closed surface, or where a surface with holes would close: the
    /// winding number (A. Jacobson et al., "Robust Inside-Outside Segmentation Using Generalized
    /// Winding Numbers", 2013) is above 1/2. Inside a surface that faces inwards is outside.
    bool encloses(const Eigen::Vector3d& point) const;

    /// What is seen of the mesh's own edges and of `lines`, which are those of
    /// extract_on_surface(), a set for each object of which the mesh consists.
    /// @throws Error(Cancelled).
    std::vector<SightLine> look(const View& view, const std::vector<LineSet>& lines,
                                const SightOptions& options, const Progress& progress = {}) const;

    /// The same as sets of lines in space.
    LineParts parts(const View& view, const std::vector<LineSet>& lines,
                    const SightOptions& options, const Progress& progress = {}) const;

private:
    struct Data;
    std::unique_ptr<const Data> data_;
};

}  // namespace laplacian_lines
