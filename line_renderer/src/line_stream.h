// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "laplacian_lines/line_set.h"
#include "line_renderer/line_renderer.h"

namespace line_renderer {

/// Half widths at full weight by kind, pixels.
using LineRadii = std::array<float, laplacian_lines::kLineKindCount>;

/// Tolerance of the simplification of lines, see StraightPiece.
struct LineTolerance {
    /// Pixels; 0: every point is written.
    float distance = 0.25f;
    float radius = 0.1f;  ///< pixels
    float opacity = 1.0f / 16;
    /// By kind: a difference of depths in -1..1 times w².
    std::array<float, laplacian_lines::kLineKindCount> depth{};
};

/// Input of the vertex shader, four consecutive points a call: it draws the segment between the
/// middle two, joined to the outer two.
struct StreamPoint {
    float position[3];  ///< mesh coordinates, less the set's origin
    float radius;       ///< pixels, or one of the marks
    float opacity;
    float look;   ///< the number of the line's kind, and the mark of what begins here
    float along;  ///< pixels along the line from its start; 0 unless they were asked for
};

/// Marks in place of a radius. Segments with a marked end are not drawn. line_shaders.cpp has
/// copies of these and of the next two.
constexpr float kNothingHere = -1;    ///< before and after a line: its ends are round
constexpr float kNeighbourOnly = -2;  ///< around a closed line: a point to join to

/// Added to the look of a point from which on a line is an edge of the mesh.
constexpr float kEdgeMark = 0.25f;
/// Likewise, of an edge that is hidden, whatever its depth.
constexpr float kAwayMark = 0.4f;

/// The most points of a set: each line stands between two marks.
std::size_t stream_length(const laplacian_lines::LineSet& lines);

struct StreamSettings {
    LineRadii radii{};
    /// From the mesh, for lengths in pixels: the middle of the screen may be anywhere.
    Eigen::Matrix4f to_clip = Eigen::Matrix4f::Identity();
    Eigen::Vector2f half_viewport = Eigen::Vector2f::Zero();
    LineTolerance tolerance;
    /// Whether points get `along`, without lengths behind the eye.
    bool is_measured = false;
};

struct StreamPart {
    std::size_t first, length;
};

/// Writes up to stream_length() points, on several threads, as parts with unwritten gaps between
/// them; never reads `stream`, which may be graphics memory. Drops points within the tolerance, but
/// no ends. Outlines come last, above the others. Does not allocate unless there are more parts
/// than before.
void write_stream(const laplacian_lines::LineSet& lines, const StreamSettings& settings,
                  StreamPoint* stream, std::vector<StreamPart>& parts);

LineRadii line_radii(const LineAppearance& appearance, double pixel_scale);

/// Depth bias of the lines of a look, eye coordinates.
double line_clearance(std::size_t look, const LinePlacement& placement);

/// `half_viewport` in pixels.
StreamSettings stream_settings(const LineAppearance& appearance, const LinePlacement& placement,
                               const Eigen::Vector2f& half_viewport);

}  // namespace line_renderer
