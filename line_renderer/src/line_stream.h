// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "laplacian_lines/line_set.h"

namespace line_renderer {

/// Half widths of lines in pixels.
struct LineRadii {
    /// For lines of full weight, by the number of their kind.
    std::array<float, laplacian_lines::line_kind_count> full{};
    float least_share = 0.35f;  ///< share of the radius that is left at weight 0
};

/// From mesh to screen, for lengths in pixels. Where the middle of the screen is does not matter.
struct ScreenTransform {
    Eigen::Matrix4f to_clip = Eigen::Matrix4f::Identity();
    Eigen::Vector2f half_viewport = Eigen::Vector2f::Zero();
};

/// How far what is drawn may be from the lines, see StraightPiece.
struct LineTolerance {
    /// Pixels; 0: every point is written.
    float distance = 0.25f;
    float radius = 0.1f;  ///< pixels
    float opacity = 1.0f / 16;
    /// By the number of the kind, as a difference of depths in -1..1 times the square of w.
    std::array<float, laplacian_lines::line_kind_count> depth{};
};

/// A point as the vertex shader sees it. Every four consecutive points are one call of the shader:
/// it draws the segment between the middle two, joined to the outer two.
struct StreamPoint {
    float position[3];  ///< mesh coordinates
    float radius;       ///< pixels, or one of the marks
    float opacity;
    float look;   ///< the number of the line's kind, and the mark of what begins here
    float along;  ///< pixels along the line from its start; 0 unless they were asked for
};

/// Marks instead of a radius. A segment with a marked end is not drawn.
constexpr float nothing_here = -1;    ///< before and after a line: its ends are round
constexpr float neighbour_only = -2;  ///< around a closed line: a point to join to

/// Added to the look of a point from which on a contour follows an edge of the mesh.
constexpr float edge_mark = 0.25f;

/// How many points a line set has as a stream at most: each line stands between two marks.
std::size_t streamLength(const laplacian_lines::LineSet& lines);

/// How a stream is written.
struct StreamSettings {
    LineRadii radii;
    ScreenTransform screen;
    LineTolerance tolerance;
    /// Whether points have their `along`. What lies behind the eye counts as no length.
    bool is_measured = false;
};

/// Points of a stream that belong together.
struct StreamPart {
    std::size_t first, length;
};

/// Writes into streamLength() points, reading none, so that `stream` may be memory of the graphics
/// card: parts with points between them that nobody has written, on several threads. Points that
/// are not needed within the tolerance are left out, but no end of a line. Outlines come last,
/// above the others. Allocates nothing while there are no more parts, of which there are few.
void writeStream(const laplacian_lines::LineSet& lines, const StreamSettings& settings,
                 StreamPoint* stream, std::vector<StreamPart>& parts);

}  // namespace line_renderer
