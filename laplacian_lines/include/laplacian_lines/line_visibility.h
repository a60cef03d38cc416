// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
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

/// Depth bias of lines: how far a point is moved towards the eye before the depth test, in D.
constexpr double kDepthBias = 0.003;
/// Of contours at least, in mean edges: smooth ones lie behind the triangles' horizon.
constexpr double kContourDepthBias = 1.5;

/// The mean edge for depth_bias(), mesh units: larger where normals are smoothed more than
/// usual; 0 where contours follow the edges of the mesh, as on coarse ones.
double depth_bias_edge(const Field& field);

/// In the unit of `diagonal` and of `depth_bias_edge`, which is that of depth_bias_edge().
inline double depth_bias(LineKind kind, double diagonal, double depth_bias_edge) {
    const double beyond = kind == LineKind::Contour ? kContourDepthBias * depth_bias_edge : 0;
    return beyond > kDepthBias * diagonal ? beyond : kDepthBias * diagonal;
}

/// Whether a line runs along the triangles' horizon, on a mesh edge, between two of its points;
/// these have no gradient. Other parts of contours are only near it.
inline bool follows_edge(LineKind kind, const LinePoint& from, const LinePoint& to) {
    return kind == LineKind::Contour && from.gradient == 0 && to.gradient == 0;
}

/// The lines of a view as they lie on the surface, for LineVisibility: unsmoothed, so that each
/// segment is on one triangle, creases whole, nothing faded beside contours. Without contours and
/// borders: LineVisibility has the mesh's own. @throws Error as LineExtractor::extract().
LineSet extract_on_surface(const LineExtractor& extractor, const View& view, const LineStyle& style,
                           ExtractionScratch& scratch);

/// What LineVisibility draws of a view.
struct VisibilityOptions {
    /// Which mesh edges are wanted: contours, borders and creases.
    LineKindSet shows = LineKindSet::defaults();
    /// As LineStyle::line_smoothing: of lines on the surface, and, unless in_picture, of contours
    /// that do not follow edges.
    double line_smoothing = 1.2;
    bool has_hidden = false;  ///< also the hidden parts of the mesh's edges
    /// Join lines that meet in the picture, even across a jump in depth, so that outlines are
    /// closed. Otherwise only lines of one kind that meet in space.
    bool in_picture = false;
    /// As LineStyle::shortest_contour, D: the least extent of connected contours and borders.
    double shortest_contour = 0;
};

constexpr std::uint32_t kNoNode = 0xffffffffu;

/// A point of a line, all of which is visible or hidden.
struct ViewLinePoint {
    Eigen::Vector3d position;         ///< mesh coordinates
    float weight, gradient, opacity;  ///< as of LinePoint
    /// Points where lines meet in the picture have equal numbers; at kNoNode none meet.
    std::uint32_t node;
    /// On an edge of the form; other points may be smoothed.
    bool is_exact;
};

/// A line of a view from one junction to the next.
struct ViewLine {
    LineKind kind;
    bool closed;  ///< ends with a copy of its first point
    bool is_hidden;
    bool is_outline;  ///< nothing is on one side of it: the outlines of a view are closed
    /// Contours and borders: largest depth from them to the surface behind, mesh units; infinite
    /// with nothing behind.
    float jump;
    float strength, slope;  ///< of the whole line that it is part of, see Polyline
    std::vector<ViewLinePoint> points;
};

/// Appends a line to a set, whose points are relative to its origin; `diagonal`: D, mesh units.
void append(const ViewLine& line, double diagonal, LineSet& to);

/// Appends lines whose nodes were counted by themselves: they get numbers of their own.
template <class Line>
void append_with_own_nodes(std::vector<Line> more, std::vector<Line>& lines) {
    std::uint32_t count = 0;
    for (const Line& line : lines)
        for (const auto& point : line.points)
            if (point.node != kNoNode) count = std::max(count, point.node + 1);
    for (Line& line : more) {
        for (auto& point : line.points)
            if (point.node != kNoNode) point.node += count;
        lines.push_back(std::move(line));
    }
}

/// Lines, cut where their visibility changes.
struct LineParts {
    LineSet seen, hidden;
};

/// Exact visibility of lines. Contours, borders, creases and intersections are mesh edges, other
/// lines lie on triangles. All are split where they cross contours and borders in the picture, and
/// one ray decides about each piece: see docs/algorithms.md. For meshes of any topology and
/// winding, which need not outlive this. Thread-safe; any number of threads gives the same.
class LineVisibility {
public:
    /// @throws Error(InvalidMesh, Cancelled)
    explicit LineVisibility(const TriangleMesh& mesh, const Progress& progress = {});
    ~LineVisibility();
    LineVisibility(LineVisibility&&) noexcept;
    LineVisibility& operator=(LineVisibility&&) noexcept;

    /// Whether a point is inside: its winding number (Jacobson et al., "Robust Inside-Outside
    /// Segmentation Using Generalized Winding Numbers", 2013) is above 1/2. Works with holes.
    bool encloses(const Eigen::Vector3d& point) const;

    /// The visible parts of the mesh's own edges and of `lines`, sets from extract_on_surface():
    /// one, or, where the mesh consists of several, one of each, in any order, in its coordinates.
    /// Hidden parts of edges if the options ask for them. @throws Error(Cancelled)
    std::vector<ViewLine> visible_lines(const View& view, const std::vector<LineSet>& lines,
                                        const VisibilityOptions& options,
                                        const Progress& progress = {}) const;

    /// The same as sets, with the origin of the first of `lines`, or 0.
    LineParts parts(const View& view, const std::vector<LineSet>& lines,
                    const VisibilityOptions& options, const Progress& progress = {}) const;

private:
    struct Data;
    std::unique_ptr<const Data> data_;
};

}  // namespace laplacian_lines
