// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"
#include "line_drawing/object.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

/// From mesh coordinates to a picture, x right, y up, with `middle` at (0, 0), where perspective
/// has the scale 1. If that is behind the eye, the point as far before it; at the eye, 1 before it.
class Projection {
public:
    /// The frame outlives this.
    Projection(const ViewFrame& frame, const Eigen::Vector3d& middle);

    Eigen::Vector2d operator()(const Eigen::Vector3d& p) const;
    /// Distance along the viewing direction from the eye, or from `middle` if orthographic.
    double depth(const Eigen::Vector3d& p) const;
    /// The point of space at a depth.
    Eigen::Vector3d unproject(const Eigen::Vector2d& picture, double depth) const;

    /// Bounds of the triangles in the picture; in perspective of what is in the field of view, or
    /// more, and empty if all is behind the eye.
    Eigen::AlignedBox2d bounds_of(const laplacian_lines::TriangleMesh& mesh) const;

    /// Clips lines to the field of view in perspective.
    std::vector<laplacian_lines::ViewLine> clip_to_view(
        std::vector<laplacian_lines::ViewLine> lines) const;

    laplacian_lines::View view() const;

private:
    const ViewFrame& frame_;
    Eigen::Vector3d origin_;           // the eye, or what is at (0, 0)
    double distance_ = 0;              // of `middle` from the eye
    Eigen::Vector2d middle_ = {0, 0};  // in the picture, from the point before the eye
};

/// The line on the surface that a point comes from.
struct LineOrigin {
    double depth = 0;  ///< see Projection, mesh units
    laplacian_lines::LineKind kind = laplacian_lines::LineKind::Contour;
    float gradient = 0, strength = 0, slope = 0;  ///< as of LinePoint and Polyline
};

struct DrawnPoint {
    Eigen::Vector2d position;
    double weight = 1;  ///< 0..1, share of the full width
    /// Equal where lines meet.
    std::uint32_t node = laplacian_lines::kNoNode;
    bool is_exact = true;      ///< on an edge of the form, a cut or a join; others may be smoothed
    bool is_smoothed = false;  ///< has been smoothed
    LineOrigin origin = {};

    /// Whether smoothing leaves it where it is.
    bool stays() const { return is_exact || is_smoothed; }
};

/// The point at a share of the way.
DrawnPoint between(const DrawnPoint& a, const DrawnPoint& b, double t);

struct DrawnLine {
    LineClass line_class;
    bool closed;  ///< ends with a copy of its first point
    std::vector<DrawnPoint> points;
    double jump = 0;  ///< of contours: largest step in depth to the surface behind, mm
    laplacian_lines::LineKind kind = laplacian_lines::LineKind::Laplacian;  ///< unused of sections
};

/// The same line with other points: an open part of it, if not closed.
DrawnLine with_points(const DrawnLine& line, std::vector<DrawnPoint> points, bool closed = false);
std::vector<Eigen::Vector2d> positions_of(const DrawnLine& line);
Eigen::AlignedBox2d box_of(const DrawnLine& line);
/// The length from the point `begin` to the one before `end`.
double length_of(const std::vector<DrawnPoint>& points, std::size_t begin = 0,
                 std::size_t end = std::size_t(-1));

/// Direction out of a line's end, from the first point `reach` away from it, or the other end.
Eigen::Vector2d outwards_at(const std::vector<DrawnPoint>& points, bool is_last, double reach);

/// Moves an end by `shift`, and the points within `reach` along the line by less and less.
void shift_end(std::vector<DrawnPoint>& points, bool is_last, const Eigen::Vector2d& shift,
               double reach);

/// Whether all of its points stay().
bool is_fixed(const DrawnLine& line);

/// Whether most of it is not exact.
bool is_smooth(const DrawnLine& line);

/// Whether a drawing may drop it or join it to another: it is neither an edge of the form nor an
/// axis.
bool is_inner(const DrawnLine& line);

/// The cut face of one object in a section: loops (even-odd), if any.
using Wall = std::vector<std::vector<Eigen::Vector2d>>;
/// Walls that overlap: one area.
using MergedWalls = std::vector<Wall>;

/// A cutting plane seen edge-on, in the view's coordinates.
struct SectionMark {
    std::string letter;
    Eigen::Vector2d point, along, looking;  ///< on the line; unit directions of line and viewing
};

/// A view in millimetres of the object, x right, y up, the middle of the bounding box at (0, 0).
struct DrawnView {
    ViewFrame frame;
    Eigen::AlignedBox2d bounds;  ///< of the surface
    std::vector<DrawnLine> lines = {};
    /// By object, where wanted.
    std::vector<std::vector<DrawnLine>> silhouettes = {};
    bool is_section = false;
    std::vector<MergedWalls> walls = {};
    std::vector<SectionMark> marks = {};
    std::string note = {};  ///< for the notes of the sheet
};

struct Placement {
    double scale;            ///< millimetres of the sheet in one of the object
    Eigen::Vector2d middle;  ///< of the view, in the sheet's coordinates

    Eigen::Vector2d on_sheet(const Eigen::Vector2d& p) const {
        return {middle.x() + scale * p.x(), middle.y() - scale * p.y()};
    }
    Eigen::AlignedBox2d on_sheet(const Eigen::AlignedBox2d& box) const {
        return Eigen::AlignedBox2d(on_sheet(box.min())).extend(on_sheet(box.max()));
    }
};

/// Projects lines to a view, times `unit`.
DrawnLine project(const std::vector<Eigen::Vector3d>& section, const Projection& projection,
                  double unit);
std::vector<DrawnLine> project(const std::vector<laplacian_lines::ViewLine>& lines,
                               const Projection& projection, double unit);

}  // namespace line_drawing
