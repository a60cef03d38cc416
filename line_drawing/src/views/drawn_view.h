// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/bounds.h"
#include "line_drawing/sheet_options.h"
#include "views/projection.h"

namespace line_drawing {

struct DrawnPoint {
    Eigen::Vector2d position;
    double weight = 1;  ///< 0..1, share of the full width
    /// Lines that meet have points of equal numbers there.
    std::uint32_t node = laplacian_lines::kNoSightNode;
    bool is_exact = true;  ///< to be kept where it is when lines are smoothed
};

struct DrawnLine {
    LineClass line_class;
    bool closed;  ///< ends with a copy of its first point
    std::vector<DrawnPoint> points;
    double jump = 0;  ///< of contours: the largest distance of what is behind them, in mm
};

std::vector<Eigen::Vector2d> positionsOf(const DrawnLine& line);
/// The length of a line from its point `begin` to its end.
double lengthOf(const std::vector<DrawnPoint>& points, std::size_t begin = 0);

/// Out of a line, of two points at least, at one of its ends: from the first point that is `reach`
/// away from it.
Eigen::Vector2d outwardsAt(const std::vector<DrawnPoint>& points, bool is_last, double reach);

/// Moves an end of a line by `shift`, and what is nearer to it along the line than `reach` by less
/// and less.
void shiftEnd(std::vector<DrawnPoint>& points, bool is_last, const Eigen::Vector2d& shift,
              double reach);

/// Whether any of it only stands for a smooth line, and may be smoothed.
bool isSmooth(const DrawnLine& line);

/// Whether it is a line within a face of the surface, which a drawing may leave out or join to
/// another one; no edge of the form, nor an axis of a section.
bool isInner(const DrawnLine& line);

/// Loops around what a section cuts of one object (even-odd); none where it cuts nothing.
using Wall = std::vector<std::vector<Eigen::Vector2d>>;
/// Those of objects that overlap: one area.
using MergedWalls = std::vector<Wall>;

/// A plane of a section that a view shows as a line. In the coordinates of the view.
struct SectionMark {
    std::string letter;
    Eigen::Vector2d point, along, looking;  ///< on the line; unit directions of the line, of sight
};

/// A view of a mesh in millimetres of the object, x right, y up, with the middle of its bounding
/// box at (0, 0).
struct DrawnView {
    ViewFrame frame;
    Eigen::AlignedBox2d bounds;  ///< of the surface
    std::vector<DrawnLine> lines = {};
    /// The outline of each object alone, where these are wanted.
    std::vector<std::vector<DrawnLine>> silhouettes = {};
    bool is_section = false;
    std::vector<MergedWalls> walls = {};
    std::vector<SectionMark> marks = {};
    std::string note = {};  ///< what the sheet has to say of it
};

/// Where a view is on its sheet.
struct Placement {
    double scale;            ///< millimetres of the sheet in one of the object
    Eigen::Vector2d middle;  ///< of the view, in the sheet's coordinates

    Eigen::Vector2d onSheet(const Eigen::Vector2d& p) const {
        return {middle.x() + scale * p.x(), middle.y() - scale * p.y()};
    }
};

/// Lines in mesh coordinates as they look in a view, times `unit`.
DrawnLine project(const std::vector<Eigen::Vector3d>& section, const Projection& projection,
                  double unit);
std::vector<DrawnLine> project(const std::vector<laplacian_lines::SightLine>& lines,
                               const Projection& projection, double unit);

}  // namespace line_drawing
